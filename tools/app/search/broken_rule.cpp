#include "tools/app/search/broken_rule.h"

#include <fmt/format.h>

#include <cassert>
#include <numeric>

#include "sim/replay/replay.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/progress.h"

namespace hyrax {
namespace {

constexpr std::int64_t kStopsMax = 2000;
constexpr std::int64_t kShrinkTrialsMax = 20'000;
constexpr std::int64_t kProgramTrialsMax = 2'000;  // Each is a process.
constexpr std::size_t kHexDigits = 2 * sizeof(Digest);

const InvariantText& text_of(Invariant invariant) {
  return kInvariantTexts[static_cast<std::size_t>(invariant)];
}

// Stopped where the failing run happened to be stopped is not known any more: at every row, unless they are
// many.
std::vector<std::int64_t> stops_for(const Scenario& scenario, Invariant invariant) {
  const std::int64_t steps = step_count(scenario);
  if (invariant != Invariant::resumed || steps > kStopsMax) return usual_stops(scenario);
  std::vector<std::int64_t> stops(static_cast<std::size_t>(steps));
  std::iota(stops.begin(), stops.end(), 0);
  return stops;
}

bool breaks(const Core& core, const Scenario& scenario, Invariant invariant) {
  const CheckedRun run = check_run(core, scenario, stops_for(scenario, invariant));
  return !run.measures[static_cast<std::size_t>(invariant)].holds &&
         !is_broken_by_listing(invariant, scenario);
}

}  // namespace

std::string BrokenRule::name() const {
  return invariant ? std::string(text_of(*invariant).name) : "state-hash";
}

std::string BrokenRule::rule() const {
  return invariant ? std::string(text_of(*invariant).rule) : "both programs give the same state hash";
}

std::optional<BrokenRule> broken_invariant(const Scenario& scenario, const CheckedRun& run) {
  const auto invariant = first_broken(scenario, run.measures);
  if (!invariant) return std::nullopt;
  const InvariantMeasure& measure = run.measures[static_cast<std::size_t>(*invariant)];
  return BrokenRule{.invariant = invariant,
                    .found = fmt::format("{:.3g} {} at step {}", measure.slack, text_of(*invariant).unit,
                                         measure.worst_step),
                    .other_end = {}};
}

std::optional<BrokenRule> different_hash(const Digest& own, const std::string& other) {
  if (hex(own) == other || other.empty()) return std::nullopt;
  return BrokenRule{.invariant = {},
                    .found = hex(own) + " here, " + other + " there",
                    .other_end = other.size() == kHexDigits ? "" : other};
}

std::optional<BrokenRule> different_hash(const Core& core, const Scenario& scenario,
                                         const OtherProgram& other) {
  const Digest own = replay(core, scenario).state_hash;
  return different_hash(own, other.state_hashes({&scenario, 1}).front());
}

Shrunk shrink_broken(const Core& core, const Scenario& scenario, const BrokenRule& broken,
                     const OtherProgram* other) {
  if (broken.invariant)
    return shrink_with_progress(
        core, scenario, [&](const Scenario& simpler) { return breaks(core, simpler, *broken.invariant); },
        kShrinkTrialsMax);
  assert(other != nullptr);
  Shrunk shrunk = shrink_with_progress(
      core, scenario,
      [&](const Scenario& simpler) {
        const auto found = different_hash(core, simpler, *other);
        return found && found->other_end == broken.other_end;
      },
      kProgramTrialsMax);
  shrunk.is_complete = shrunk.is_complete && !other->is_over();
  return shrunk;
}

Shrunk shrink_with_progress(const Core& core, const Scenario& scenario,
                            const std::function<bool(const Scenario&)>& fails, std::int64_t trials_max) {
  Progress progress;
  const auto report = [&](std::int64_t trials, const Scenario& smallest) {
    progress.show_text(fmt::format("{} tried, the smallest has {} and {}", plain_counted(trials, "scenario"),
                                   plain_counted(step_count(smallest), "frame"),
                                   plain_counted(smallest.events.size(), "event")));
  };
  return shrink(core, scenario, fails, {.trials_max = trials_max, .report = report});
}

}  // namespace hyrax

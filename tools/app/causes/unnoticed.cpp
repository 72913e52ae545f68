#include "tools/app/causes/core_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/cause/watched_core.h"
#include "sim/compare/run_distance.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/shrink.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kSearchSeed = 1;
constexpr std::int64_t kSearchSteps = 300'000;
constexpr std::size_t kSearchedMax = 8;  // Of many differences the first are searched for.
constexpr double kConsequence_s = 5.0;
constexpr std::int64_t kConsequenceSteps = 100'000;
constexpr std::int64_t kShrinkTrials = 500;

// The frames that were found.
Scenario scenario_of(const DifferenceSearch& search) {
  const auto& [state, window, sprite, is_held] = search.found->world;
  const double dt_s = search.found->dt_s;
  const double rate_hz = std::round(1.0 / dt_s);
  Scenario scenario = scenario_from(state, window, sprite, rate_hz, search.frames);
  if (!(dt_s > 0.0 && rate_hz >= 1.0 && 1.0 / rate_hz == dt_s)) scenario.clock.base = FixedStep{dt_s};
  return scenario;
}

// The same for the same scenario, so that files of different ones do not replace each other.
std::string name_of(Scenario scenario) {
  scenario.name = "unnoticed";
  const std::string text = scenario_file_text(scenario);
  return "unnoticed-" + hex(digest(std::as_bytes(std::span(text)))).substr(0, 8);
}

// The accepted core, this program's, and their steps.
struct CorePair {
  const StepPair& steps;
  const Core& accepted;
  const Core& program;
};

std::string consequence_of(const CorePair& cores, Scenario scenario) {
  const double dt_s = base_dt_s(scenario.clock);
  const double steps = dt_s > 0.0 ? std::ceil(kConsequence_s / dt_s) : 1.0;
  scenario.length = static_cast<std::int64_t>(std::min(steps, static_cast<double>(kConsequenceSteps)));
  const RunSummary before = play(cores.accepted, scenario);
  const RunSummary after = play(cores.program, scenario);
  if (after.non_finite_step) return fmt::format("not finite from step {}", *after.non_finite_step);
  const State from = state_of(before.final), to = state_of(after.final);
  const double apart_px = distance_px(from, to);
  const double apart_px_per_s =
      std::hypot(to.vx_px_per_s - from.vx_px_per_s, to.vy_px_per_s - from.vy_px_per_s);
  const bool is_of_speed = apart_px == 0.0 && apart_px_per_s > 0.0;
  return fmt::format("after {:.3g} s {} {} apart", after.final.t_s,
                     rounded(is_of_speed ? apart_px_per_s : apart_px, 3), is_of_speed ? "px/s" : "px");
}

// Whether the cores give the scenario other rows.
bool differs(const CorePair& cores, const Scenario& scenario) {
  return play(cores.accepted, scenario).state_hash != play(cores.program, scenario).state_hash;
}

// Marks in `noticed` (one a difference) those that a row of the scenario shows, played by the accepted core.
void mark_noticed(const CorePair& cores, const Scenario& scenario, std::vector<bool>& noticed) {
  std::vector<bool> evaluated(noticed.size());
  const auto take = [&](const StepInput& input, std::span<TracedBody> bodies) {
    if (std::ranges::find(noticed, false) != noticed.end())
      cores.steps.notice(input, bodies, evaluated, noticed);
  };
  static_cast<void>(play(watched(cores.accepted, cores.steps.programs(), take), scenario));
}

// By difference: whether the scenario shows it.
std::vector<bool> shown_by(const CorePair& cores, const Scenario& scenario) {
  std::vector<bool> shown(cores.steps.differences().size());
  mark_noticed(cores, scenario, shown);
  return shown;
}

std::vector<UnnoticedDifference> search_unnoticed(const CorePair& cores, const std::vector<bool>& noticed) {
  std::vector<UnnoticedDifference> unnoticed;
  std::vector<std::optional<std::size_t>> shown(noticed.size());  // By which of `unnoticed`.
  std::size_t searched = 0;
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    if (noticed[index]) continue;
    UnnoticedDifference difference = shown[index] ? unnoticed[*shown[index]] : UnnoticedDifference();
    difference.text = cores.steps.differences()[index].text;
    if (!shown[index]) {
      const DifferenceSearch search =
          cores.steps.search(index, kSearchSeed, ++searched > kSearchedMax ? 0 : kSearchSteps);
      difference.steps_tried = search.steps_tried;
      if (search.found) {
        const auto shows = [&](const Scenario& scenario) {
          return differs(cores, scenario) && shown_by(cores, scenario)[index];
        };
        Scenario scenario =
            shrink(cores.program, scenario_of(search), shows, {.trials_max = kShrinkTrials}).scenario;
        Scenario unsigned_dt = scenario;  // A dt of -0 only where it is what differs.
        if (auto* const step = std::get_if<FixedStep>(&unsigned_dt.clock.base))
          step->dt_s = std::fabs(step->dt_s);
        if (shows(unsigned_dt)) scenario = std::move(unsigned_dt);
        const std::vector<bool> others = shown_by(cores, scenario);
        for (std::size_t other = index + 1; other < others.size(); ++other)
          if (others[other] && !shown[other]) shown[other] = unnoticed.size();
        difference.consequence = consequence_of(cores, scenario);
        scenario.name = name_of(scenario);
        difference.scenario = std::move(scenario);
      }
    }
    unnoticed.push_back(std::move(difference));
  }
  return unnoticed;
}

}  // namespace

LibraryNotice notice(const StepPair& steps, const Core& accepted, const Core& program,
                     const std::vector<std::string>& scenarios_folders) {
  const CorePair cores{steps, accepted, program};
  LibraryNotice found;
  std::vector<bool> noticed(steps.differences().size());
  std::vector<Failure> unlisted;
  for (const std::string& path : list_scenarios(scenarios_folders, unlisted)) try {
      const bool is_open = std::ranges::find(noticed, false) != noticed.end();
      if (!is_open && (found.is_noticed || steps.are_setters_equal())) break;
      const Scenario scenario = load_scenario(path);
      mark_noticed(cores, scenario, noticed);
      if (!steps.are_setters_equal()) found.is_noticed = found.is_noticed || differs(cores, scenario);
    } catch (const Failure&) {
    }
  found.unnoticed = search_unnoticed(cores, noticed);
  found.is_noticed = found.is_noticed || std::ranges::find(noticed, true) != noticed.end();
  return found;
}

}  // namespace hyrax

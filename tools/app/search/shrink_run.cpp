#include "tools/app/search/shrink_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/run_check.h"
#include "sim/search/scenario_edit.h"
#include "tools/app/command_line/print.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/controlled_core.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/failure.h"
#include "tools/files/golden_place.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {
namespace {

using SteadyClock = std::chrono::steady_clock;

std::string first_word(const std::string& text) { return text.substr(0, text.find(' ')); }

bool has_line(const std::string& lines, std::string_view line) {
  return fmt::format("\n{}", lines).find(fmt::format("\n{}\n", line)) != std::string::npos;
}

// What a run can say, in the order in which one is chosen.
enum class FindingKind : std::uint8_t { end, non_finite, expectation, invariant, other_bits };
struct Finding {
  FindingKind kind;
  std::string text;
};

// Stopped where the failing run happened to be stopped is not known: at every row, unless they are many.
std::vector<std::int64_t> every_stop(const Scenario& scenario) {
  constexpr std::int64_t kStopsMax = 2000;
  const std::int64_t steps = step_count(scenario);
  if (steps > kStopsMax) return usual_stops(scenario);
  std::vector<std::int64_t> stops(static_cast<std::size_t>(steps));
  std::iota(stops.begin(), stops.end(), 0);
  return stops;
}

std::string breaks_text(Invariant invariant) { return fmt::format("breaks {}", text_of(invariant).name); }

std::string broken_names(const Core& core, const Scenario& scenario, bool stops_everywhere) {
  const CheckedRun run =
      check_run(core, scenario, stops_everywhere ? every_stop(scenario) : usual_stops(scenario));
  std::string names;
  for (const Invariant invariant : broken_invariants(scenario, run.measures))
    names += breaks_text(invariant) + "\n";
  return names;
}

// A state hash has no side: any other run would differ, too.
std::string broken_sides(const Core& core, const Scenario& scenario, const RunSummary& run) {
  std::string sides;
  for (const Expectation& each : broken_expectations(core, scenario, run)) {
    if (each.rule == "state_hash") continue;
    const auto* const measured = std::get_if<double>(&each.measured);
    sides += each.rule +
             (!each.range                   ? " is not " + each.wanted
              : measured == nullptr         ? " has no value"
              : *measured < each.range->low ? " is below its range"
                                            : " is above its range") +
             "\n";
  }
  return sides;
}

std::string non_finite_name(const Scenario& scenario, const RunSummary& run) {
  const std::string text = non_finite_text(scenario, run.final);
  return text.empty() ? "" : first_word(text) + " becomes non-finite\n";
}

// `expect` with this rule alone.
Scenario with_rule_only(const Scenario& scenario, const std::string& rule) {
  Json document = to_json(scenario);
  const auto leave = [](Json::Object& object, std::string_view key) {
    std::erase_if(object, [&](const auto& member) { return member.first != key; });
  };
  const std::string key = rule.substr(0, rule.find('/'));
  for (auto& [name, expect] : *document.get<Json::Object>()) {
    if (name != "expect") continue;
    leave(*expect.get<Json::Object>(), key);
    if (key != rule)
      leave(*expect.get<Json::Object>()->front().second.get<Json::Object>(), rule.substr(key.size() + 1));
  }
  return to_scenario(document, "expect", scenario.name);
}

// Plays runs that may end their process.
class Player {
 public:
  /// @param is_guarded each run has a child process; else this process is one.
  Player(const Core& core, const std::optional<Core>& accepted, double limit_s, bool is_guarded)
      : core_(core), accepted_(accepted), limit_s_(limit_s), is_guarded_(is_guarded) {}

  [[nodiscard]] std::optional<Finding> first(const Scenario& scenario) const {
    for (const FindingKind kind : {FindingKind::end, FindingKind::non_finite, FindingKind::expectation,
                                   FindingKind::invariant, FindingKind::other_bits})
      if (const std::string found = find(kind, scenario, true); !found.empty())
        return Finding{kind, found.substr(0, found.find('\n'))};
    return std::nullopt;
  }

  [[nodiscard]] bool has(const Finding& kept, const Scenario& scenario) const {
    const bool stops_everywhere = kept.text == breaks_text(Invariant::resumed);
    return has_line(find(kept.kind, scenario, stops_everywhere), kept.text);
  }

  [[nodiscard]] std::optional<Scenario> after(const Scenario& scenario, std::int64_t frames) const {
    const WorkEnd end = run_guarded([&]() -> std::string {
      try {
        return scenario_file_text(after_frames(core_, scenario, frames));
      } catch (const std::exception&) {
        return "";
      }
    });
    try {
      return parse_scenario(end.result.value_or(""), "a later start");
    } catch (const Failure&) {  // The run ends before, or with a state beyond the limits of the format.
      return std::nullopt;
    }
  }

 private:
  [[nodiscard]] WorkEnd run_guarded(const std::function<std::string()>& work) const {
    if (is_guarded_) return in_child("hyrax-sim shrink", {.wall_s = limit_s_}, work);
    limit_wall_time(limit_s_);
    return {.result = work()};
  }

  // All that is found of a kind, in lines.
  [[nodiscard]] std::string find(FindingKind kind, const Scenario& scenario, bool stops_everywhere) const {
    const WorkEnd end = run_guarded([&]() -> std::string {
      try {
        return find_here(kind, scenario, stops_everywhere);
      } catch (const CoreFailure& failure) {
        return kind == FindingKind::end ? failure.without_row() + "\n" : "";
      } catch (const std::exception& error) {
        return kind == FindingKind::end ? fmt::format("exception: {}\n", error.what()) : "";
      }
    });
    if (end.result) return *end.result;
    return kind == FindingKind::end ? end_text(end, limit_s_) + "\n" : "";
  }

  [[nodiscard]] std::string find_here(FindingKind kind, const Scenario& scenario,
                                      bool stops_everywhere) const {
    const Core core = with_parameters(core_, scenario.parameters).value();
    if (kind == FindingKind::invariant) return broken_names(core, scenario, stops_everywhere);
    const RunSummary run = play(core, scenario);
    if (kind == FindingKind::non_finite) return non_finite_name(scenario, run);
    if (kind == FindingKind::expectation) return broken_sides(core, scenario, run);
    const auto accepted = accepted_ ? with_parameters(*accepted_, scenario.parameters) : std::nullopt;
    const bool is_other =
        kind == FindingKind::other_bits && accepted && play(*accepted, scenario).state_hash != run.state_hash;
    return is_other ? "other bits than the accepted core's\n" : "";
  }

  const Core& core_;
  const std::optional<Core>& accepted_;
  double limit_s_;
  bool is_guarded_;
};

Shrunk shrink_with_progress(const Core& core, const Scenario& scenario,
                            const std::function<bool(const Scenario&)>& fails, ShrinkOptions options) {
  Progress progress;
  options.report = [&](std::int64_t trials, const Scenario& smallest) {
    progress.show_text(fmt::format("{} tried, the smallest has {} and {}", plain_counted(trials, "scenario"),
                                   plain_counted(step_count(smallest), "frame"),
                                   plain_counted(smallest.events.size(), "event")));
  };
  return shrink(core, scenario, fails, options);
}

// Nothing: there is nothing to keep.
std::optional<ShrunkRun> search(const Core& core, const Player& player, Scenario scenario,
                                SteadyClock::time_point end) {
  const std::optional<Finding> kept = player.first(scenario);
  if (!kept) return std::nullopt;
  if (kept->kind == FindingKind::expectation) scenario = with_rule_only(scenario, first_word(kept->text));
  const std::int64_t steps_min = std::min<std::int64_t>(step_count(scenario), 1);  // None plays nothing.
  const ShrinkOptions options{
      .is_over = [&] { return SteadyClock::now() >= end; },
      .start_later = [&](const Scenario& each, std::int64_t frames) { return player.after(each, frames); }};
  return ShrunkRun{kept->text, shrink_with_progress(
                                   core, scenario,
                                   [&](const Scenario& simpler) {
                                     return step_count(simpler) >= steps_min && player.has(*kept, simpler);
                                   },
                                   options)};
}

// From a child process.
std::string to_line(const std::optional<ShrunkRun>& run) {
  if (!run) return "";
  const auto& [kept, shrunk] = *run;
  return to_text(Json(
      Json::Array{kept, to_json(shrunk.scenario), shrunk.trials, shrunk.fails_again, shrunk.is_complete}));
}
std::optional<ShrunkRun> from_line(const std::string& line) {
  if (line.empty()) return std::nullopt;
  const Json document = parse_json(line, "shrink");
  const Json::Array& run = *document.get<Json::Array>();
  return ShrunkRun{*run[0].get<std::string>(),
                   {.scenario = to_scenario(run[1], "shrink", ""),
                    .trials = static_cast<std::int64_t>(run[2].number()),
                    .fails_again = *run[3].get<bool>(),
                    .is_complete = *run[4].get<bool>()}};
}

}  // namespace

ShrunkRun shrink_run(const Core& core, const std::string& path, const Scenario& scenario,
                     const ShrinkLimits& limits) {
  const std::string golden = golden_folder_of(path);
  const std::optional<Core> accepted = accepted_step(golden, core);
  const SteadyClock::time_point end =
      SteadyClock::now() + std::chrono::milliseconds(std::llround(1e3 * std::min(limits.search_s, 1e9)));
  const auto search_in = [&](bool is_guarded) {
    return search(core, Player(core, accepted, limits.run_s, is_guarded), scenario, end);
  };
  const WorkEnd together = in_child("hyrax-sim shrink", {.wall_s = limits.run_s, .is_silent = false},
                                    [&] { return to_line(search_in(false)); });
  auto run = together.result ? from_line(*together.result) : search_in(true);
  if (!run)
    refuse_input(fmt::format(
        "{}: nothing to keep: the run ends, stays finite, and breaks neither `expect` (state_hash aside) nor "
        "an invariant; {}",
        path,
        accepted         ? "the accepted core gives the same bits"
        : golden.empty() ? "it is below no folder named scenarios, so that it has no accepted core"
                         : "there is no accepted core that can be played in " + accepted_core_folder(golden) +
                               " (see `hyrax-sim check --core`)"));
  return *std::move(run);
}

Shrunk shrink_broken(const Core& core, const Scenario& scenario, const std::optional<Invariant>& invariant,
                     const std::string& thrown) {
  const auto fails = [&](const Scenario& simpler) {
    try {
      const std::string names = broken_names(core, simpler, invariant == Invariant::resumed);
      return invariant && has_line(names, breaks_text(*invariant));
    } catch (const CoreFailure& failure) {
      return failure.without_row() == thrown;
    }
  };
  const auto start_later = [&](const Scenario& each, std::int64_t frames) -> std::optional<Scenario> {
    try {
      return after_frames(core, each, frames);
    } catch (const CoreFailure&) {
      return std::nullopt;
    }
  };
  return shrink_with_progress(core, scenario, fails, {.start_later = start_later});
}

}  // namespace hyrax

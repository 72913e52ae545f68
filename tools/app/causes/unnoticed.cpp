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
#include "tools/app/play/play.h"
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

// Of velocities where the positions are the same.
std::string apart_text(double px, double px_per_s) {
  const bool is_of_speed = px == 0.0 && px_per_s > 0.0;
  return fmt::format("{} {} apart", rounded(is_of_speed ? px_per_s : px, 3), is_of_speed ? "px/s" : "px");
}

// The scenario shows the difference in its last step: it is played on for what becomes of that.
std::string consequence_of(const CorePair& cores, Scenario scenario) {
  const double dt_s = base_dt_s(scenario.clock);
  const double steps = dt_s > 0.0 ? std::ceil(kConsequence_s / dt_s) : 1.0;
  scenario.length = static_cast<std::int64_t>(std::min(steps, static_cast<double>(kConsequenceSteps)));
  const RowBatches before = played_rows(cores.accepted, scenario);
  const RowBatches after = played_rows(cores.program, scenario);
  Columns from, to;
  Row last;
  double px = 0.0, px_per_s = 0.0, largest_px = 0.0, largest_px_per_s = 0.0;
  for (before(from), after(to); from.size() > 0 && from.size() == to.size(); before(from), after(to))
    for (std::size_t index = 0; index < to.size(); ++index) {
      const Row row = from.row(index);
      last = to.row(index);
      px = distance_px(state_of(row), state_of(last));
      px_per_s = std::hypot(last.vx_px_per_s - row.vx_px_per_s, last.vy_px_per_s - row.vy_px_per_s);
      largest_px = std::max(largest_px, px);
      largest_px_per_s = std::max(largest_px_per_s, px_per_s);
    }
  const std::string played = fmt::format("played for {:.3g} s, ", last.t_s);
  if (const std::optional<std::int64_t> step = play(cores.program, scenario).non_finite_step)
    return played + fmt::format("not finite from step {}", *step);
  if (px > 0.0 || px_per_s > 0.0) return played + "ends " + apart_text(px, px_per_s);
  return played + "ends in the same state, after at most " + apart_text(largest_px, largest_px_per_s);
}

// Whether the cores give the scenario other rows.
bool differs(const CorePair& cores, const Scenario& scenario) {
  return play(cores.accepted, scenario).state_hash != play(cores.program, scenario).state_hash;
}

// Marks in `noticed` (one a difference) those that decide a row of the scenario, played by the accepted core.
void mark_noticed(const CorePair& cores, const Scenario& scenario, std::vector<bool>& noticed) {
  std::vector<DifferenceWatch> watches(noticed.size());
  const auto take = [&](const StepInput& input, std::span<TracedBody> bodies) {
    if (std::ranges::find(noticed, false) != noticed.end())
      cores.steps.notice(input, bodies, watches, noticed);
  };
  static_cast<void>(play(watched(cores.accepted, cores.steps.programs(), take), scenario));
}

// By difference: whether the scenario shows it.
std::vector<bool> shown_by(const CorePair& cores, const Scenario& scenario) {
  std::vector<bool> shown(cores.steps.differences().size());
  mark_noticed(cores, scenario, shown);
  return shown;
}

// The smallest scenario that still shows the difference, its frame not of -0 s unless that is what differs.
Scenario smallest(const CorePair& cores, const Scenario& found, std::size_t difference) {
  const auto shows = [&](const Scenario& scenario) {
    return differs(cores, scenario) && shown_by(cores, scenario)[difference];
  };
  Scenario scenario = shrink(cores.program, found, shows, {.trials_max = kShrinkTrials}).scenario;
  Scenario unsigned_dt = scenario;
  if (auto* const step = std::get_if<FixedStep>(&unsigned_dt.clock.base)) step->dt_s = std::fabs(step->dt_s);
  if (shows(unsigned_dt)) scenario = std::move(unsigned_dt);
  scenario.name = name_of(scenario);
  return scenario;
}

// Looks for a scenario that shows the difference.
UnnoticedDifference searched(const CorePair& cores, std::size_t difference, std::int64_t steps_max) {
  const DifferenceSearch search = cores.steps.search(difference, kSearchSeed, steps_max);
  UnnoticedDifference unnoticed;
  unnoticed.steps_tried = search.steps_tried;
  if (search.found) {
    unnoticed.scenario = smallest(cores, scenario_of(search), difference);
    unnoticed.consequence = consequence_of(cores, *unnoticed.scenario);
  } else if ((search.further_members & ~cores.steps.unrecorded()) == 0) {
    unnoticed.unrecorded = search.further_members;
  }
  return unnoticed;
}

// Each difference that is not noticed: with a scenario that was found for one before it, if that shows it,
// too; else with one that is searched for.
std::vector<UnnoticedDifference> find_unnoticed(const CorePair& cores, const std::vector<bool>& noticed) {
  std::vector<UnnoticedDifference> unnoticed;
  std::vector<std::vector<bool>> shown;  // By each of these, where it has a scenario: the differences.
  std::size_t searches = 0;
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    if (noticed[index]) continue;
    const auto earlier = std::ranges::find_if(shown, [&](const std::vector<bool>& by) { return by[index]; });
    UnnoticedDifference difference =
        earlier != shown.end() ? unnoticed[static_cast<std::size_t>(earlier - shown.begin())]
                               : searched(cores, index, ++searches > kSearchedMax ? 0 : kSearchSteps);
    difference.text = cores.steps.differences()[index].text;
    shown.push_back(difference.scenario ? shown_by(cores, *difference.scenario)
                                        : std::vector<bool>(noticed.size()));
    unnoticed.push_back(std::move(difference));
  }
  return unnoticed;
}

}  // namespace

LibraryNotice notice(const StepPair& steps, const Core& accepted, const Core& program,
                     const std::vector<std::string>& scenarios_folders) {
  const CorePair cores{steps, accepted, program};
  std::vector<bool> noticed(steps.differences().size());
  bool is_setter_noticed = steps.are_setters_equal();  // Or there is nothing to notice.
  std::vector<Failure> unlisted;
  for (const std::string& path : list_scenarios(scenarios_folders, unlisted)) try {
      if (is_setter_noticed && std::ranges::find(noticed, false) == noticed.end()) break;
      const Scenario scenario = load_scenario(path);
      if (!scenario.parameters.empty()) continue;  // Of other constants than the steps that are compared.
      mark_noticed(cores, scenario, noticed);
      is_setter_noticed = is_setter_noticed || differs(cores, scenario);
    } catch (const Failure&) {
    }
  const bool is_noticed =
      std::ranges::find(noticed, true) != noticed.end() || (!steps.are_setters_equal() && is_setter_noticed);
  return {is_noticed, find_unnoticed(cores, noticed)};
}

}  // namespace hyrax

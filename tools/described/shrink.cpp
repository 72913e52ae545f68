#include <chrono>

#include "sim/scenario/frame_clock.h"
#include "tools/app/library/shrink_flow.h"
#include "tools/described/broken_rule.h"
#include "tools/described/commands.h"
#include "tools/described/scenario_json.h"
#include "tools/files/failure.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {
namespace {

ScenarioSize size_of(const DescribedScenario& scenario) {
  return {step_count(scenario), std::ssize(scenario.events)};
}

// What the smaller one says, too.
std::string kept_of(const BrokenRule& broken) {
  if (broken.rule == "always") return "property \"" + broken.of + "\" is broken";
  if (broken.rule == "expect") return "expect: " + broken.of;
  if (broken.rule == "resumed") return "stopped and resumed, it goes on otherwise";
  return broken.of.empty() ? "the description is not complete" : broken.of;
}

SmallerScenario find_smaller(const DescribedCore& core, const std::string& path, const ShrinkLimits& limits) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(limits.search_s));
  const DescribedScenario scenario = load_described_scenario(core.description, path);
  // Each run that crashes, or does not end, has a process of its own.
  const auto end_of = [&](const DescribedScenario& played) {
    const WorkEnd end_of_run = in_child("hyrax-sim shrink", {.wall_s = limits.run_s}, [&] {
      static_cast<void>(play(core, played, {}));
      return std::string();
    });
    return end_of_run.result ? "" : end_text(end_of_run, limits.run_s);
  };
  const bool crashes = !end_of(scenario).empty();
  const FindBroken find = [&](const DescribedScenario& played, const auto& asks) {
    if (!crashes) return broken_rules(core, played, asks);
    const std::string how = end_of(played);
    return how.empty() ? std::vector<BrokenRule>()
                       : std::vector{BrokenRule{"ends", how, "", step_count(played)}};
  };
  const std::vector<BrokenRule> broken = find(scenario, [](std::string_view) { return true; });
  if (broken.empty())
    refuse_input(
        path +
        ": nothing to keep: the run ends, stays finite, breaks no property and no rule of `expect`, its "
        "description is complete, and stopped and resumed it goes on as without a stop");
  ShrunkScenario smaller = shrunk(find, scenario, broken.front(), [end] { return Clock::now() >= end; });
  const std::string kept = kept_of(smaller.broken);
  smaller.scenario.description = shrunk_from(scenario.name, step_count(scenario), kept);
  return {.kept = kept,
          .text = to_text(to_json(core.description, smaller.scenario), 1) + "\n",
          .before = size_of(scenario),
          .after = size_of(smaller.scenario),
          .trials = smaller.trials,
          .is_complete = smaller.is_complete};
}

}  // namespace

Command described_shrink_command(const DescribedCore& core) {
  return shrink_command_of(
      "that it throws, ends the program, does not end, is not finite, breaks a property or a rule of "
      "`expect`, shows that the description is "
      "not complete, or goes on otherwise where it is stopped and resumed",
      [&core](const Core& /*paper*/, const std::string& path, const ShrinkLimits& limits) {
        return find_smaller(core, path, limits);
      });
}

}  // namespace hyrax

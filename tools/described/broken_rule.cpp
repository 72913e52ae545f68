#include "tools/described/broken_rule.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/described/described_comparison.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/expect/judged_run.h"

namespace hyrax {
namespace {

// "above" its range, or "below"; empty of a rule without one.
std::string side_of(const Expectation& expectation) {
  const auto* const measured = std::get_if<double>(&expectation.measured);
  if (measured == nullptr || !expectation.range) return "";
  return *measured < expectation.range->low ? " below" : " above";
}

class Shrinker {
 public:
  Shrinker(const FindBroken& find, const DescribedScenario& scenario, const BrokenRule& broken,
           const std::function<bool()>& is_over)
      : find_(find), is_over_(is_over), result_{.scenario = scenario, .broken = broken} {}

  ShrunkScenario shrink() {
    shorten();
    drop_each(&DescribedScenario::events);
    drop_each(&DescribedScenario::parameters);
    drop_each(&DescribedScenario::inputs);
    drop_each(&DescribedScenario::input_arrays);
    drop_each(&DescribedScenario::start);
    DescribedScenario steady = result_.scenario;
    steady.clock.jitter.reset();
    if (result_.scenario.clock.jitter) keep_if_broken(steady);
    shorten();  // Without what was dropped, the rule may be broken earlier.
    return std::move(result_);
  }

 private:
  bool keep_if_broken(const DescribedScenario& smaller) {
    if (!result_.is_complete || is_over_()) return result_.is_complete = false;
    ++result_.trials;
    for (const BrokenRule& again :
         find_(smaller, [&](std::string_view rule) { return rule == result_.broken.rule; })) {
      if (!again.is_same_rule(result_.broken)) continue;
      result_.scenario = smaller;
      result_.broken = again;
      return true;
    }
    return false;
  }

  bool keep_if_broken_after(std::int64_t steps) {
    DescribedScenario shorter = result_.scenario;
    const std::vector<TimedEvent> events = timed_events(shorter, step_count(shorter));
    std::vector<DescribedEvent> kept;
    for (const TimedEvent& event : events)
      if (event.frame < steps) kept.push_back({event.frame, *event.action});
    shorter.events = std::move(kept);
    for (InputArray& input : shorter.input_arrays) input.words.resize(static_cast<std::size_t>(steps));
    if (auto* const trace = std::get_if<RecordedSteps>(&shorter.clock.base)) {
      if (steps == 0) return false;  // A file holds one at least.
      trace->dt_s.resize(static_cast<std::size_t>(steps));
    }
    shorter.length = steps;
    return keep_if_broken(shorter);
  }

  void shorten() {
    keep_if_broken_after(result_.broken.step);
    for (std::int64_t cut = (step_count(result_.scenario) + 1) / 2; cut > 0; cut /= 2)
      while (step_count(result_.scenario) >= cut &&
             keep_if_broken_after(step_count(result_.scenario) - cut)) {
      }
  }

  void drop_each(auto member) {
    for (std::size_t index = (result_.scenario.*member).size(); index-- > 0;) {
      DescribedScenario smaller = result_.scenario;
      drop(smaller.*member, index);
      keep_if_broken(smaller);
    }
  }
  static void drop(auto& list, std::size_t index) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  }
  // A hold takes the `go` behind it along, which no file may have alone.
  static void drop(std::vector<DescribedEvent>& events, std::size_t index) {
    const auto is_go = [](const DescribedEvent& event) { return std::holds_alternative<Go>(event.action); };
    if (is_go(events[index])) return;
    const bool is_hold = std::holds_alternative<Hold>(events[index].action);
    const auto behind = events.erase(events.begin() + static_cast<std::ptrdiff_t>(index));
    if (const auto go = std::find_if(behind, events.end(), is_go); is_hold && go != events.end())
      events.erase(go);
  }

  const FindBroken& find_;
  const std::function<bool()>& is_over_;
  ShrunkScenario result_;
};

// A text that a core throws, without numbers that it may tell.
std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return std::string_view("0123456789.e+-").find(c) != std::string::npos; });
  return text;
}

}  // namespace

bool BrokenRule::is_same_rule(const BrokenRule& other) const {
  return rule == other.rule &&
         (rule == "throws" ? without_numbers(of) == without_numbers(other.of) : of == other.of);
}

std::vector<BrokenRule> broken_rules(const DescribedCore& core, const DescribedScenario& scenario,
                                     const std::function<bool(std::string_view rule)>& asks) {
  std::vector<BrokenRule> all;
  const DescribedSummary run = play(core, scenario, {});
  const std::int64_t steps = step_count(scenario);
  if (const auto& early = run.early_end)
    all.push_back({early->is_non_finite ? "finite" : "throws", early->what,
                   fmt::format("{} at step {}", early->what, early->step), early->step});
  for (std::size_t place = 0; place < run.properties.size(); ++place) {
    const PropertyInfo& property = core.description.properties[place];
    const std::int64_t step = run.properties[place].step.value_or(steps);
    if (property.is_always && !run.properties[place].holds)
      all.push_back({"always", property.name, fmt::format("\"{}\" at step {}", property.name, step), step});
  }
  if (scenario.expect)
    for (const Expectation& expectation : judge(core.description, *scenario.expect, run))
      if (!expectation.holds)
        all.push_back(
            {"expect", expectation.rule + side_of(expectation), expectation_text(expectation), steps});
  if (asks("complete"))
    if (const auto fault = description_fault(core, scenario, run.steps))
      all.push_back({"complete", "", *fault, steps});
  if (asks("resumed"))
    if (const auto fault = resumed_fault(core, scenario, run.steps))
      all.push_back({"resumed", "", *fault, steps});
  return all;
}

ShrunkScenario shrunk(const FindBroken& find, const DescribedScenario& scenario, const BrokenRule& broken,
                      const std::function<bool()>& is_over) {
  return Shrinker(find, scenario, broken, is_over).shrink();
}

}  // namespace hyrax

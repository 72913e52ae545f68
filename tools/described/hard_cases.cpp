// `hyrax-sim study hard-cases` of a core that describes itself: what every run must hold, however hard.
#include <fmt/format.h>

#include <algorithm>

#include "sim/described/described_comparison.h"
#include "sim/described/scripted_body.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/described/broken_rule.h"
#include "tools/described/commands.h"

namespace hyrax {
namespace {

struct HardRun {
  std::string made_from = {};  ///< Name of a scenario.
  std::string why = {};        ///< Why it is hard.
  DescribedScenario scenario = {};
  std::vector<BrokenRule> broken = {};
};

class Family {
 public:
  explicit Family(const Description& description, const DescribedScenario& scenario)
      : description_(description), base_(scenario), steps_(step_count(scenario)) {
    base_.expect.reset();
    std::vector<DescribedEvent> events;
    for (const TimedEvent& event : timed_events(scenario, steps_))
      events.push_back({event.frame, *event.action});
    base_.events = std::move(events);
    has_clock_ = !std::holds_alternative<RecordedSteps>(base_.clock.base);
    if (has_clock_) base_.length = steps_;
    runs.push_back({scenario.name, "as it is", scenario});
  }

  void add_limits() {
    for (const SettableList list : {SettableList::state, SettableList::inputs, SettableList::parameters}) {
      const std::vector<ValueInfo>& values = list_of(description_, list).values;
      for (std::size_t place = 0; place < values.size(); ++place) {
        if (!values[place].limits) continue;
        for (const auto& [name, limit] : {std::pair("lowest", 0), {"highest", 1}}) {
          const Word word = (*values[place].limits)[static_cast<std::size_t>(limit)];
          if (is_floating(values[place].type) && !is_finite(word)) continue;
          DescribedScenario& scenario =
              add(fmt::format("{}-{}", name, values[place].name), "a value at its limit");
          std::vector<GivenValue>& given = given_of(scenario, list);
          std::erase_if(given, [place](const GivenValue& each) { return each.first == place; });
          given.emplace_back(place, word);
          if (list == SettableList::inputs)
            std::erase_if(scenario.input_arrays,
                          [place](const InputArray& array) { return array.input == place; });
          std::ranges::sort(given, {}, &GivenValue::first);
        }
      }
    }
  }

  void add_clocks(bool has_long) {
    if (!has_clock_) return;
    for (const double dt_s : {0.0, 4.9406564584124654e-324, 1e-310, 1e-9, 1e-6, 1e-3, 0.02, 0.25, 0.5, 10.0,
                              1e3, 1e6, kFrameMax_s})
      add(fmt::format("dt-{:g}", dt_s), "a frame far from the usual").clock = {FixedStep{dt_s}, {}};
    for (const auto& [name, jitter] : {std::pair("uniform-1", Jitter{Jitter::Kind::uniform, 1.0, 2026}),
                                       {"normal-0.02", Jitter{Jitter::Kind::normal, 0.02, 2026}},
                                       {"missed-0.5", Jitter{Jitter::Kind::missed_frames, 0.5, 2026}}})
      add(fmt::format("jitter-{}", name), "no two frames take the same time").clock.jitter = jitter;
    for (const double dt_s : {0.5, 3600.0, 28800.0}) {
      std::vector<DescribedEvent>& events =
          add(fmt::format("hitch-{:g}-s", dt_s), "one frame takes long").events;
      const std::int64_t frame = steps_ / 3;
      events.insert(std::ranges::find_if(events,
                                         [frame](const DescribedEvent& event) {
                                           return std::get<std::int64_t>(event.when) > frame;
                                         }),
                    {frame, Hitch{dt_s}});
    }
    constexpr std::int64_t kLong = 100'000;
    if (has_long && base_.input_arrays.empty() && steps_ < kLong)
      add(fmt::format("{}-steps", kLong), "long after the last input: nothing may add up").length = kLong;
  }

  std::vector<HardRun> runs = {};

 private:
  DescribedScenario& add(const std::string& what, const std::string& why) {
    HardRun& run = runs.emplace_back(HardRun{base_.name, why, base_});
    run.scenario.name += "/" + what;
    return run.scenario;
  }
  static std::vector<GivenValue>& given_of(DescribedScenario& scenario, SettableList list) {
    return list == SettableList::state    ? scenario.start
           : list == SettableList::inputs ? scenario.inputs
                                          : scenario.parameters;
  }

  const Description& description_;
  DescribedScenario base_;
  std::int64_t steps_;
  bool has_clock_ = false;
};

// The first sentence that breaks the rule; nothing: it holds.
const BrokenRule* broken_of(const HardRun& run, std::string_view rule) {
  const auto broken = std::ranges::find(run.broken, rule, &BrokenRule::rule);
  return broken == run.broken.end() ? nullptr : &*broken;
}

Table case_table(const std::vector<HardRun>& runs) {
  Table table{"cases",
              "every case, and the rules that it breaks",
              {column_of("case", "", "case", runs, [](const HardRun& run) { return run.scenario.name; }),
               column_of("made_from", "", "scenario it is, or was made from", runs, &HardRun::made_from),
               column_of("why", "", "why it is hard", runs, &HardRun::why),
               column_of("steps", "1", "frames of the scenario", runs,
                         [](const HardRun& run) { return step_count(run.scenario); })}};
  for (const std::string_view rule : kGeneralRules)
    table.columns.push_back(
        column_of(std::string(rule), "", "held or broken", runs, [rule](const HardRun& run) {
          return std::string(broken_of(run, rule) == nullptr ? "held" : "broken");
        }));
  return table;
}

Table rule_table(const std::vector<HardRun>& runs) {
  const auto broken = [&runs](std::string_view rule) {
    return std::ranges::count_if(runs,
                                 [rule](const HardRun& run) { return broken_of(run, rule) != nullptr; });
  };
  return {"rules",
          "",
          {column_of("rule", "", "", kGeneralRules, [](std::string_view rule) { return std::string(rule); }),
           column_of("cases", "1", "", kGeneralRules, [&](std::string_view) { return std::ssize(runs); }),
           column_of("broken", "1", "", kGeneralRules, broken)}};
}

Figure figure_of(const std::vector<HardRun>& runs) {
  Grid grid;
  for (const std::string_view rule : kGeneralRules) grid.columns.emplace_back(rule, Tone::ink);
  for (auto run = runs.begin(); run != runs.end();) {
    const auto end = std::find_if(run, runs.end(),
                                  [run](const HardRun& each) { return each.made_from != run->made_from; });
    const std::size_t row = grid.rows.size();
    grid.rows.push_back(fmt::format("{} ×{}", run->made_from, end - run));
    for (std::size_t column = 0; column < kGeneralRules.size(); ++column) {
      const auto broken = std::count_if(
          run, end, [&](const HardRun& each) { return broken_of(each, kGeneralRules[column]) != nullptr; });
      const std::int64_t held = end - run - broken;
      const double middle = broken == 0 ? 1.0 : held == 0 ? 0.0 : 0.5;
      if (held > 0) grid.cells.push_back({row, column, Tone::good, std::to_string(held), 0.0, middle});
      if (broken > 0) grid.cells.push_back({row, column, Tone::bad, std::to_string(broken), middle, 1.0});
    }
    run = end;
  }
  return {.title = fmt::format("{} hard cases", runs.size()),
          .subtitle = "What every run must hold; numbers: cases in which it does, and does not",
          .body = std::move(grid),
          .legend = {{"held", {.form = Form::bars, .tone = Tone::good}},
                     {"broken", {.form = Form::bars, .tone = Tone::bad}}}};
}

}  // namespace

Result study_hard_cases(const DescribedCore& core, const std::vector<DescribedScenario>& scenarios,
                        const StudyInput& input) {
  std::vector<HardRun> runs;
  for (const DescribedScenario& scenario : scenarios) {
    Family family(core.description, scenario);
    family.add_clocks(!input.is_quick);
    family.add_limits();
    std::ranges::move(family.runs, std::back_inserter(runs));
  }
  std::int64_t done = 0, failing = 0, steps = 0;
  Verdict verdict;
  for (HardRun& run : runs) {
    run.broken = broken_rules(core, run.scenario, [](std::string_view) { return true; });
    std::erase_if(run.broken, [](const BrokenRule& broken) { return broken.rule == "expect"; });
    for (const BrokenRule& broken : run.broken)
      verdict.broken.push_back(fmt::format("{}: {}: {}", run.scenario.name, broken.rule, broken.found));
    if (!run.broken.empty()) ++failing;
    steps += step_count(run.scenario);
    input.report_progress("cases", ++done, std::ssize(runs));
  }
  verdict.answer =
      fmt::format("{}: {} broken.", plain_counted(runs.size(), "hard case"),
                  failing == 0 ? "none is" : fmt::format("{} {}", failing, failing == 1 ? "is" : "are"));
  verdict.text = {fmt::format("{}, each case held to these rules:", counted(steps, "step")),
                  rule_table(runs)};
  Result result{.tables = {case_table(runs)},
                .figures = {figure_of(runs)},
                .verdict = std::move(verdict),
                .summary = {case_table(runs)}};
  result.figures.front().title = headline(result.verdict);
  return result;
}

}  // namespace hyrax

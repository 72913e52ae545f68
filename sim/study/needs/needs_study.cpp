// `hyrax-sim study needs`: its tables, figures and verdict.
#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "sim/core/listing_core.h"
#include "sim/result/number_text.h"
#include "sim/study/needs/needs.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

constexpr double kWithin_px = 1.0;
// The cheapest method is only searched for up to so many scenarios: each takes a second or more.
constexpr std::size_t kScenariosWithMethodsMax = 4;
constexpr std::size_t kPartsPrintedMax = 30;

using Needs = const ScenarioNeeds&;

StudyTable<std::vector<ScenarioNeeds>> scenario_table(const std::string& name, const std::string& long_name,
                                                      const std::vector<ScenarioNeeds>& scenarios) {
  return StudyTable(name, long_name, scenarios)
      .add("scenario", "", "what is played", &ScenarioNeeds::scenario);
}

std::int64_t path_count_taken(Needs needs) { return std::ssize(needs.paths_taken); }

// In JSON the member `parts` of a scenario.
Table part_table(std::span<const ScenarioNeeds> scenarios) {
  struct PartOfScene {
    const ScenarioNeeds* needs;
    const PartNeed* part;
  };
  std::vector<PartOfScene> rows;
  for (const ScenarioNeeds& needs : scenarios)
    for (const PartNeed& part : needs.parts) rows.push_back({&needs, &part});
  using R = const PartOfScene&;
  return StudyTable("parts", "every part of model and scene left out in turn", rows)
      .add("scenario", "", "what is played", [](R r) { return r.needs->scenario; })
      .key("-")
      .add("part", "", "what is left out", [](R r) { return r.part->part; })
      .add("verdict", "", "needed, alone or with others left out; below the tolerance; or not exercised",
           [](R r) { return name_of(r.part->need); })
      .add("path_difference", "px", "largest distance at equal times",
           [](R r) { return r.part->difference.path_px; })
      .key("path_px")
      .add("first_step", "1", "first row that differs; -1: none",
           [](R r) { return r.part->difference.first_step; })
      .key("-")
      .add("contacts_moved", "1", "contacts that moved, appeared or vanished",
           [](R r) { return r.part->difference.contacts_moved; })
      .add("end_shift", "px", "distance at the end", [](R r) { return r.part->difference.end_px; })
      .key("end_px")
      .add("saves", "", "whether a step takes less time without it, beyond the noise",
           [](R r) { return r.part->saves(); })
      .add_estimate(
          "saved", "ns", "time saved per step, median; missing where the path changes",
          [](R r) { return r.part->saved_ns_per_step; }, "saved_ns_per_step")
      .add("step", "ns", "time of a step with all parts, median", [](R r) { return r.needs->step_ns.median; })
      .key("-");
}

// The cheapest point of a scenario's methods, or of the paper's step; nullptr if there is none.
const WorkPoint* cheapest_of(const ScenarioNeeds& needs, bool of_paper = false) {
  if (!needs.methods) return nullptr;
  const CheapestBelow& answer = needs.methods->cheapest.front();
  const PointIndex& point = of_paper ? answer.paper_point : answer.point;
  return point ? &needs.methods->points[*point] : nullptr;
}

Table cheapest_table(const std::vector<ScenarioNeeds>& scenarios) {
  std::vector<ScenarioNeeds> searched;
  std::copy_if(scenarios.begin(), scenarios.end(), std::back_inserter(searched),
               [](Needs needs) { return needs.methods.has_value(); });
  // A value of the cheapest point, or of the paper's step.
  const auto value = [](bool of_paper, const auto& get) {
    return [=](Needs needs) {
      const WorkPoint* const point = cheapest_of(needs, of_paper);
      return point != nullptr ? get(*point) : kNotGiven;
    };
  };
  const auto rate = [](const WorkPoint& point) { return point.rate_hz; };
  const auto cost = [](const WorkPoint& point) { return point.cost.time_ns.median; };
  return scenario_table("cheapest", "the cheapest method and rate within the tolerance of the exact motion",
                        searched)
      .add("method", "", "the cheapest",
           [](Needs needs) {
             const WorkPoint* const point = cheapest_of(needs);
             return point != nullptr ? needs.methods->methods[point->method].name : "none";
           })
      .add("rate", "Hz", "its frames per second", value(false, rate))
      .add("cost", "ns/s", "its median cost", value(false, cost))
      .add("paper_rate", "Hz", "of the paper's step; missing: at no rate", value(true, rate))
      .add("paper_cost", "ns/s", "its median cost", value(true, cost));
}

// The JSON member `cheapest` of a scenario.
Table cheapest_summary(const ScenarioNeeds& needs) {
  Table table{"cheapest", "", {}, JsonForm::one};
  if (const WorkPoint* const point = cheapest_of(needs))
    table.columns = {column_of_one("method", "", needs.methods->methods[point->method].name),
                     column_of_one("rate", "Hz", point->rate_hz),
                     column_of_one("cost", "ns/s", point->cost.time_ns.median)};
  return table;
}

std::size_t path_count(const StepProgram& core_step) {
  return core_step.step().paths_of(CoreFunction::update).size();
}

std::string paths_text(const std::set<std::uint32_t>& taken, const StepProgram& core_step) {
  return fmt::format("{} of {} paths", taken.size(), path_count(core_step));
}

std::vector<Table> summary_of(const std::vector<ScenarioNeeds>& scenarios, double within_px,
                              const StepProgram* core_step) {
  const auto paths = core_step == nullptr ? kNotGiven : static_cast<double>(path_count(*core_step));
  return {
      {.columns = {column_of_one("within", "px", within_px), column_of_one("paths", "1", paths),
                   column_of_one("paths_taken", "1", std::ssize(paths_taken(scenarios)))},
       .form = JsonForm::members},
      scenario_table("scenes", "", scenarios)
          .add("steps", "1", &ScenarioNeeds::steps)
          .add("step", "ns", [](Needs needs) { return needs.step_ns.median; })
          .add("parts", "",
               [](Needs needs) {
                 return part_table({&needs, 1});
               })
          .add("paths_taken", "1", path_count_taken)
          .add("without_all_unneeded", "px", [](Needs needs) { return needs.without_all_unneeded.path_px; })
          .add("cheapest", "", cheapest_summary),
      {"exercised_by_none", "", {{"part", "", "", never_exercised(scenarios)}}, JsonForm::values}};
}

// A scenario's parts as they are printed; what is not exercised has no difference.
Table printed_parts(const ScenarioNeeds& needs) {
  const std::span parts = std::span(needs.parts).first(std::min(needs.parts.size(), kPartsPrintedMax));
  using D = const PathDifference&;
  const auto moved = [](const auto& value) {
    return [value](const PartNeed& part) {
      return part.need == Need::not_exercised ? kNotGiven : value(part.difference);
    };
  };
  return StudyTable("parts", "", parts)
      .add("left_out", "", &PartNeed::part)
      .add("path_moves", "px", moved([](D difference) { return difference.path_px; }), 3)
      .add("contacts_moved", "1", moved([](D difference) { return double(difference.contacts_moved); }), 3)
      .add("end_moves", "px", moved([](D difference) { return difference.end_px; }), 3)
      .add(
          "saves", "ns",
          [](const PartNeed& part) {
            return part.saves() ? std::round(100.0 * part.saved_ns_per_step.median) / 100.0 : kNotGiven;
          },
          3)
      .add("verdict", "", [](const PartNeed& part) { return name_of(part.need); });
}

// "exact flight, swept clamp from 120 Hz": the methods that are within the tolerance at 60 Hz or above, each
// at its lowest rate.
std::string within_text(const SpeedError& methods, double within_px) {
  std::string text;
  for (std::size_t method = 0; method < methods.methods.size(); ++method) {
    if (methods.methods[method].is_reference()) continue;
    const auto within = std::ranges::find_if(methods.points, [&](const WorkPoint& point) {
      return point.method == method && point.rate_hz >= kRowRate_hz && !point.errors.is_failed &&
             point.errors.position_px < within_px;
    });
    if (within != methods.points.end())
      text += fmt::format("{}{} at {:.0f} Hz", text.empty() ? "" : ", ", methods.methods[method].label,
                          within->rate_hz);
  }
  return text.empty() ? "none of the methods" : text;
}

// How near the paper's step gets, where none of its rates that were timed is near enough.
std::string paper_scan_text(const SpeedError& methods, double within_px) {
  const auto least = std::ranges::find(methods.least, std::size_t{0}, &LeastError::method);
  if (least == methods.least.end() || std::isnan(least->position_px)) return "";
  const std::string at = fmt::format("{} px at {:.4g} Hz", rounded(least->position_px, 3), least->rate_hz);
  return least->position_px < within_px
             ? "\nThe paper's step gets that close, but at none of the rates that are timed: " + at + "."
             : fmt::format(
                   "\nThe paper's step does not get that close at any rate from {:g} to {:g} Hz: at "
                   "best {}.",
                   methods.low_hz, methods.high_hz, at);
}

std::string cheapest_text(const ScenarioNeeds& needs, double within_px) {
  if (!needs.methods) return "\nNo cheapest method: " + needs.why_no_methods + ".";
  const SpeedError& methods = *needs.methods;
  const WorkPoint* const best = cheapest_of(needs);
  const WorkPoint* const paper = cheapest_of(needs, true);
  const std::string head = fmt::format("\nCheapest within {:g} px of the exact motion: ", within_px);
  const std::vector<std::size_t>& as_cheap = methods.cheapest.front().as_cheap;
  if (best == nullptr && !(methods.probe.is_steady() && as_cheap.empty())) {
    const std::string within = within_text(methods, within_px);
    return fmt::format("{}{}; that near: {}.{}", head, unsteady_text(methods.probe), within,
                       within.starts_with("the paper's step at") ? "" : paper_scan_text(methods, within_px));
  }
  if (best == nullptr) return head + "none of the methods gets that close.";
  std::string text =
      fmt::format("{}{} at {:.0f} Hz, {:.0f} ns per simulated second.", head,
                  methods.methods[best->method].label, best->rate_hz, best->cost.time_ns.median);
  if (!as_cheap.empty())
    text +=
        fmt::format("\nIt is not cheaper in every process than {}{}.", point_text(methods, as_cheap.front()),
                    as_cheap.size() > 1 ? fmt::format(" and {} more", as_cheap.size() - 1) : "");
  if (paper == nullptr) text += paper_scan_text(methods, within_px);
  if (paper != nullptr && paper != best)
    text += fmt::format("\nThe paper's step gets that close at {:.0f} Hz, {:.0f} ns per simulated second.",
                        paper->rate_hz, paper->cost.time_ns.median);
  return text;
}

// "gravity, drag and ground".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t each = 0; each < names.size(); ++each)
    text += (each == 0 ? "" : each + 1 == names.size() ? " and " : ", ") + names[each];
  return text;
}

// "first-fling needs gravity, drag and ground; without the left wall and top it keeps its bits and a step
// takes 3.0 of 3.2 ns."
std::string answer_of(const ScenarioNeeds& needs) {
  std::vector<std::string> needed, others;
  for (const PartNeed& part : needs.parts) (is_unneeded(part.need) ? others : needed).push_back(part.part);
  std::string text =
      fmt::format("{} needs {}", needs.scenario, needed.empty() ? "no part alone" : listed(needed));
  if (others.empty()) return text + ".";
  const PathDifference& without = needs.without_all_unneeded;
  text += fmt::format("; without {} ", listed(others));
  text += without.is_same_bits     ? "it keeps its bits"
          : without.path_px == 0.0 ? "only its speed changes"
                                   : fmt::format("it moves by {} at most", length_text(without.path_px));
  if (std::isnan(needs.unneeded_out_ns.median) || std::isnan(needs.step_ns.median)) return text + ".";
  return fmt::format("{} and a step takes {:.2f} of {:.2f} ns.", text, needs.unneeded_out_ns.median,
                     needs.step_ns.median);
}

void add_needs(Verdict& verdict, const ScenarioNeeds& needs, double within_px, const StudyRequest& request) {
  const std::string sentence = answer_of(needs);
  verdict.text.push_back(fmt::format(
      "{}Within {:g} px of the run with all parts, over {}{} steps ({}):",
      sentence == verdict.answer ? "" : (verdict.text.empty() ? "" : "\n") + sentence + "\n", within_px,
      needs.is_cut ? "its first " : "", needs.steps, needs.comes_to_rest ? "settles" : "does not settle"));
  verdict.text.emplace_back(printed_parts(needs));
  if (needs.parts.size() > kPartsPrintedMax)
    verdict.text.push_back(fmt::format("  and {} more, in the files", needs.parts.size() - kPartsPrintedMax));
  verdict.text.push_back(fmt::format(
      "{}{}{}",
      request.core_step
          ? fmt::format("It takes {} of the step.\n", paths_text(needs.paths_taken, *request.core_step))
          : "",
      !std::isnan(needs.step_ns.median)
          ? fmt::format("Times on {}: medians; of all rows against the step with all parts, "
                        "{:.2f} ns ({:.2f} .. {:.2f}).",
                        request.machine, needs.step_ns.median, needs.step_ns.low, needs.step_ns.high)
          : "Times of steps: " + unsteady_text(needs.probe) + ".",
      cheapest_text(needs, within_px)));
}

// Of one scenario what it needs; where that is too long for a few lines, how many parts.
std::string answer_of(const std::vector<ScenarioNeeds>& scenarios) {
  constexpr std::size_t kLettersMax = 240;
  if (scenarios.size() > 1) return fmt::format("{} scenarios need some of their parts.", scenarios.size());
  const ScenarioNeeds& needs = scenarios.front();
  const std::string sentence = answer_of(needs);
  return sentence.size() <= kLettersMax
             ? sentence
             : fmt::format("{} needs {} of {} parts.", needs.scenario,
                           std::ssize(needs.parts) - unneeded_count(needs), needs.parts.size());
}

Result run_needs(const StudyRequest& request) {
  if (request.scenarios.empty())
    throw RequestRefused(
        "hyrax-sim study needs: a scenario must be given; `hyrax-sim study needs scenarios` takes all");
  const bool has_few_scenarios = request.scenarios.size() <= kScenariosWithMethodsMax;
  NeedsOptions options;
  options.within_px = request.within_px.value_or(kWithin_px);
  options.core_step = request.core_step;
  options.cost.is_only = request.is_costs_only;
  if (request.is_quick) options.cost.sample_ns = 5'000;
  if (has_few_scenarios)
    options.rates_hz =
        request.is_quick ? std::vector{15.0, 60.0, 240.0}
                         : std::vector{15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0};
  std::vector<ScenarioNeeds> scenarios;
  for (const NamedScenario& named : request.scenarios) {
    if (request.report_progress)
      request.report_progress("scenarios", std::ssize(scenarios), std::ssize(request.scenarios));
    const Core core = with_parameters(request.core, named.scenario.parameters).value();
    if (request.core_step && !core.parameters.empty())
      options.core_step = make_step_program(listing_step(*core.constants));
    scenarios.push_back(study_needs(core, named.scenario, options, request.measure_costs));
    options.core_step = request.core_step;
  }
  if (request.is_costs_only) return {};
  const double within_px = options.within_px;
  Result result{.tables = {part_table(scenarios), coverage_table(scenarios), cheapest_table(scenarios)},
                .summary = summary_of(scenarios, within_px, options.core_step.get())};
  if (has_few_scenarios) {
    result.verdict.answer = answer_of(scenarios);
    for (const ScenarioNeeds& needs : scenarios) {
      add_needs(result.verdict, needs, within_px, request);
      result.figures.push_back(needs_figure(needs, within_px));
    }
  } else {
    result.verdict = coverage_verdict(scenarios, within_px);
    if (options.core_step)
      result.verdict.text.push_back(
          fmt::format("They take {} of the step.", paths_text(paths_taken(scenarios), *options.core_step)));
    result.figures = {coverage_figure(scenarios, within_px)};
  }
  return result;
}

}  // namespace

Study needs_study() {
  return {.name = "needs",
          .summary = "which parts of the model and events a scenario needs, and the cheapest method for it",
          .takes_within = true,
          .run = run_needs};
}

}  // namespace hyrax

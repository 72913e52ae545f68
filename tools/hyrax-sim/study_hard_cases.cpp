#include "tools/hyrax-sim/study_hard_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_case_table.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/command_line/progress.h"
#include "tools/report/hard_cases_figure.h"

namespace hyrax {
namespace {

constexpr char kDefaultFolder[] = "scenarios/hard";

std::vector<HardCase> cases_of(const StudyRequest& request) {
  const std::vector<std::string> arguments =
      request.scenarios.empty() ? std::vector<std::string>{kDefaultFolder} : request.scenarios;
  std::vector<HardCase> cases;
  std::set<std::string> names;
  for (const std::string& path : list_scenarios(arguments))
    for (HardCase& hard_case : hard_cases_of(load_scenario(path))) {
      if (!names.insert(hard_case.name).second)
        throw Failure(ExitCode::bad_input, path + ": another scenario of the name " + hard_case.name +
                                               " was given; rename one of them");
      if (!(hard_case.is_long && request.is_quick)) cases.push_back(std::move(hard_case));
    }
  if (cases.empty())
    throw Failure(ExitCode::bad_input,
                  "hyrax-sim study hard-cases: with --quick no case is left; leave it out");
  return cases;
}

std::vector<PlayedCase> play(std::vector<HardCase> cases) {
  std::int64_t steps = 0, done = 0;
  for (const HardCase& hard_case : cases) steps += step_count(hard_case.scenario);
  Progress progress("steps", steps);
  std::vector<PlayedCase> played;
  for (HardCase& hard_case : cases) {
    const HardCaseResult result =
        play_hard_case(hard_case, [&](std::int64_t watched) { progress.show(done + watched); });
    done += step_count(hard_case.scenario);
    played.push_back({std::move(hard_case), result});
  }
  return played;
}

std::string invariant_line(const std::vector<PlayedCase>& cases, Invariant invariant) {
  const InvariantText& text = kInvariantTexts[static_cast<std::size_t>(invariant)];
  const InvariantSummary summary = summarise(cases, invariant);
  if (summary.asked == 0) return "";
  const std::string margin =
      summary.held == 0 ? "-" : fmt::format("{:.3g} {}", summary.margin, text.unit == "1" ? "" : text.unit);
  return fmt::format("  {:<15} {:>4} of {:<4} {:>8} {:>7}  {:<14} {}\n", text.name, summary.held,
                     summary.asked, summary.findings, summary.broken, margin, summary.nearest);
}

// The findings, those of the same words together.
std::string findings_text(const std::vector<PlayedCase>& cases) {
  std::map<std::string, std::vector<std::string>> cases_by_finding;
  for (const PlayedCase& played : cases)
    for (const Finding& finding : played.hard_case.findings)
      if (judge(played.hard_case, played.result, finding.invariant) == CaseVerdict::finding)
        cases_by_finding[finding.what].push_back(played.hard_case.name);
  std::string text;
  for (const auto& [what, names] : cases_by_finding)
    text += fmt::format(
        "  finding: {}\n           {}{}\n", what,
        fmt::join(names.begin(), names.begin() + std::min<std::ptrdiff_t>(3, std::ssize(names)), ", "),
        names.size() > 3 ? fmt::format(" and {} more", names.size() - 3) : std::string());
  return text;
}

std::string verdict_text(const std::vector<PlayedCase>& cases) {
  std::int64_t steps = 0, edges = 0;
  for (const PlayedCase& played : cases) {
    steps += played.result.steps;
    edges += played.result.knife_edges;
  }
  std::string text = fmt::format("hard-cases: {} cases, {} steps, every one watched\n", cases.size(), steps);
  text += fmt::format("  {:<15} {:>12} {:>8} {:>7}  {:<14} {}\n", "invariant", "held in", "findings",
                      "broken", "least margin", "in the case");
  for (std::size_t index = 0; index < kInvariantCount; ++index)
    text += invariant_line(cases, static_cast<Invariant>(index));
  if (edges > 0) text += fmt::format("  {} decisions about a wall lay within rounding of it\n", edges);
  return text + findings_text(cases);
}

Json::Object json_of(const std::vector<PlayedCase>& cases) {
  Json::Array entries;
  for (const PlayedCase& played : cases) {
    Json::Object invariants;
    for (std::size_t index = 0; index < kInvariantCount; ++index) {
      const InvariantMeasure& measure = played.result.measures[index];
      if (!measure.is_asked) continue;
      const CaseVerdict verdict = judge(played.hard_case, played.result, static_cast<Invariant>(index));
      invariants.push_back(
          {std::string(kInvariantTexts[index].name), Json::Object{{"verdict", name_of(verdict)},
                                                                  {"margin", measure.margin},
                                                                  {"worst_step", measure.worst_step}}});
    }
    entries.push_back(Json::Object{{"case", played.hard_case.name},
                                   {"made_from", played.hard_case.made_from},
                                   {"steps", played.result.steps},
                                   {"knife_edges", played.result.knife_edges},
                                   {"invariants", std::move(invariants)}});
  }
  return {{"cases", std::move(entries)}};
}

}  // namespace

StudyOutcome make_hard_cases(const StudyRequest& request) {
  const std::vector<PlayedCase> cases = play(cases_of(request));
  return {.tables = {hard_case_verdicts(cases), hard_case_list(cases)},
          .figures = {{"", hard_cases_figure_script(cases)}},
          .verdict = verdict_text(cases),
          .broken = broken_sentences(cases),
          .json = json_of(cases)};
}

}  // namespace hyrax

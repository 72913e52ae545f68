// `hyrax-sim study hard-cases`: its tables, figure and verdict.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/study.h"

namespace hyrax {
namespace {

// As files and JSON have it.
std::string_view name_of(CaseVerdict verdict) {
  constexpr std::array<std::string_view, 4> kNames = {"held", "finding", "broken", "finding gone"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::vector<HardCase> cases_of(const StudyRequest& request) {
  std::vector<HardCase> cases;
  for (const NamedScenario& named : request.scenarios)
    for (HardCase& hard_case : hard_cases_of(request.core, named.scenario))
      if (!(hard_case.is_long && request.is_quick)) cases.push_back(std::move(hard_case));
  if (cases.empty())
    throw RequestRefused("hyrax-sim study hard-cases: no case is left with --quick; run it without");
  return cases;
}

std::vector<PlayedCase> play(std::vector<HardCase> cases, const StudyRequest& request) {
  std::int64_t steps = 0, done = 0;
  for (const HardCase& hard_case : cases) steps += step_count(hard_case.scenario);
  std::vector<PlayedCase> played;
  for (HardCase& hard_case : cases) {
    const HardCaseResult result = play_hard_case(request.core, hard_case, [&](std::int64_t checked) {
      if (request.report_progress) request.report_progress("steps", done + checked, steps);
    });
    done += step_count(hard_case.scenario);
    played.push_back({std::move(hard_case), result});
  }
  return played;
}

Table verdict_table(const std::vector<Judgement>& judgements) {
  using J = const Judgement&;
  return {"verdicts",
          "every case against every invariant that was checked in it",
          {column_of("case", "", "case", judgements, [](J j) { return j.played->hard_case.name; }),
           column_of("invariant", "", "what must hold", judgements, [](J j) { return j.text().name; }),
           column_of("verdict", "", "held, finding (an expected failure), broken, or finding gone (it holds)",
                     judgements, [](J j) { return name_of(j.verdict); }),
           column_of("margin", "", "smallest margin to the bound, below 0 if broken", judgements,
                     [](J j) { return j.measure().slack; }),
           column_of("margin_unit", "", "unit of the margin", judgements, [](J j) { return j.text().unit; }),
           column_of("worst_step", "1", "row number of the smallest margin", judgements,
                     [](J j) { return j.measure().worst_step; })}};
}

using PlayedRef = const PlayedCase&;

Table case_table(const std::vector<PlayedCase>& cases) {
  return {
      "cases",
      "the cases",
      {column_of("case", "", "case", cases, [](PlayedRef played) { return played.hard_case.name; }),
       column_of("made_from", "", "scenario it is, or was made from", cases,
                 [](PlayedRef played) { return played.hard_case.made_from; }),
       column_of("why", "", "why it is hard", cases, [](PlayedRef played) { return played.hard_case.why; }),
       column_of("steps", "1", "steps played and checked", cases,
                 [](PlayedRef played) { return played.result.summary.steps; }),
       column_of("knife_edges", "1", "decisions about a wall within rounding", cases,
                 [](PlayedRef played) { return played.result.knife_edges; })}};
}

// The members of the JSON document.
Table summary_of(const std::vector<PlayedCase>& cases) {
  std::vector<Column> columns = case_table(cases).columns;
  std::erase_if(columns, [](const Column& column) { return column.name == "why"; });
  columns.push_back(column_of("invariants", "", "", cases, [](PlayedRef played) {
    std::vector<Column> verdicts = verdict_table(judgements_of({&played, 1})).columns;
    std::erase_if(verdicts,
                  [](const Column& column) { return column.name == "case" || column.name == "margin_unit"; });
    return Table{"invariants", "", std::move(verdicts), JsonShape::by_first};
  }));
  return {"cases", "", std::move(columns)};
}

Table invariant_table(const std::vector<Judgement>& judgements) {
  std::vector<std::pair<const InvariantText*, InvariantCount>> counts;
  for (std::size_t index = 0; index < kInvariantCount; ++index)
    if (InvariantCount each = count(judgements, static_cast<Invariant>(index)); each.cases > 0)
      counts.emplace_back(&kInvariantTexts[index], std::move(each));
  using C = const std::pair<const InvariantText*, InvariantCount>&;
  return {
      "invariants",
      "",
      {column_of("invariant", "", "", counts, [](C each) { return each.first->name; }),
       column_of("cases", "1", "", counts, [](C each) { return each.second.cases; }),
       column_of("held", "1", "", counts, [](C each) { return each.second.held; }),
       column_of("expected_failures", "1", "", counts, [](C each) { return each.second.expected_failures; }),
       column_of("broken", "1", "", counts, [](C each) { return each.second.broken; }),
       column_of(
           "least_slack", "1", "", counts, [](C each) { return each.second.slack; }, 3),
       column_of(
           "unit", "", "", counts,
           [](C each) { return each.first->unit == "1" ? "" : unit_text(std::string(each.first->unit)); }),
       column_of("in_case", "", "", counts, [](C each) { return each.second.least_slack_case; })}};
}

// What the listing itself breaks in any scenario (is_broken_by_listing) is known without the case's saying
// so.
std::string expected_failure_text(const Judgement& judgement) {
  if (judgement.invariant == Invariant::comes_to_rest) return judgement.played->hard_case.never_at_rest;
  return judgement.invariant == Invariant::mirror
             ? "the sprite is wider than the window: both side walls clamp it, and the left one always wins"
             : "drag acts once a frame, even in a zero-length frame";
}

// The expected failures that occurred, those of the same text together.
std::vector<std::string> expected_failure_sentences(const std::vector<Judgement>& judgements) {
  std::map<std::string, std::vector<std::string>> cases_by_text;
  for (const Judgement& judgement : judgements)
    if (judgement.verdict == CaseVerdict::expected_failure)
      cases_by_text[expected_failure_text(judgement)].push_back(judgement.played->hard_case.name);
  constexpr std::ptrdiff_t kCasesMax = 3;
  std::vector<std::string> sentences;
  for (const auto& [text, cases] : cases_by_text) {
    const std::ptrdiff_t more = std::ssize(cases) - kCasesMax;
    sentences.push_back(
        fmt::format("  expected failure: {}\n    {}{}", text,
                    fmt::join(cases.begin(), more > 0 ? cases.begin() + kCasesMax : cases.end(), ", "),
                    more > 0 ? fmt::format(" and {} more", more) : std::string()));
  }
  return sentences;
}

std::string broken_sentence(const Judgement& judgement) {
  const InvariantMeasure& measure = judgement.measure();
  const InvariantText& text = judgement.text();
  const std::string head = fmt::format("{}: {}", judgement.played->hard_case.name, text.name);
  if (measure.holds) return head + " holds: its expected failure is out of date";
  if (judgement.invariant == Invariant::expectations)
    return fmt::format("{}: {}", head, judgement.played->result.broken_expectation);
  return fmt::format("{} is broken by {:.3g} {} in row {} ({})", head, -measure.slack,
                     unit_text(std::string(text.unit)), measure.worst_step, text.rule);
}

Verdict verdict_of(const std::vector<PlayedCase>& cases, const std::vector<Judgement>& judgements) {
  std::int64_t steps = 0, knife_edges = 0;
  for (const PlayedCase& played : cases) {
    steps += played.result.summary.steps;
    knife_edges += played.result.knife_edges;
  }
  Verdict verdict{
      {fmt::format("hard-cases: {} cases, {}, each step checked", cases.size(), counted(steps, "step")),
       invariant_table(judgements)},
      {}};
  if (knife_edges > 0)
    verdict.text.push_back(
        fmt::format("  rounding alone decided {} whether a wall was met", counted(knife_edges, "time")));
  for (std::string& sentence : expected_failure_sentences(judgements))
    verdict.text.push_back(std::move(sentence));
  for (const Judgement& judgement : judgements)
    if (judgement.verdict == CaseVerdict::broken || judgement.verdict == CaseVerdict::expected_failure_gone)
      verdict.broken.push_back(broken_sentence(judgement));
  return verdict;
}

Figure figure_of(const std::vector<PlayedCase>& cases, const std::vector<Judgement>& judgements) {
  std::vector<std::pair<std::string, std::int64_t>> origins;  // In the cases' order, each with how many.
  std::int64_t steps = 0;
  for (const PlayedCase& played : cases) {
    const std::string& origin = played.hard_case.made_from;
    const auto known = std::ranges::find(origins, origin, &std::pair<std::string, std::int64_t>::first);
    (known == origins.end() ? origins.emplace_back(origin, 0) : *known).second += 1;
    steps += played.result.summary.steps;
  }
  Grid grid;
  InvariantCount all;
  for (const InvariantText& text : kInvariantTexts) grid.columns.emplace_back(text.name, Tone::ink);
  for (const auto& [origin, members] : origins) {
    const std::size_t row = grid.rows.size();
    grid.rows.push_back(members > 1 ? fmt::format("{} ×{}", origin, members) : origin);
    for (std::size_t column = 0; column < kInvariantCount; ++column) {
      const InvariantCount counted = count(judgements, static_cast<Invariant>(column), origin);
      all.held += counted.held;
      all.expected_failures += counted.expected_failures;
      all.broken += counted.broken;
      std::vector<std::pair<std::int64_t, Tone>> parts = {{counted.held, Tone::good},
                                                          {counted.expected_failures, Tone::notable},
                                                          {counted.broken, Tone::bad}};
      std::erase_if(parts, [](const auto& part) { return part.first == 0; });
      const double width = 1.0 / static_cast<double>(std::max<std::size_t>(parts.size(), 1));
      for (std::size_t part = 0; part < parts.size(); ++part) {
        const double left = width * static_cast<double>(part);
        grid.cells.push_back(
            {row, column, parts[part].second, std::to_string(parts[part].first), left, left + width});
      }
    }
  }
  return {.title = fmt::format("{} hard cases", cases.size()),
          .subtitle = fmt::format("Invariants checked in each of {} steps; numbers: cases with that verdict",
                                  fmt::group_digits(steps)),
          .body = std::move(grid),
          .legend = {{fmt::format("held: {}", all.held), {.form = Form::bars, .tone = Tone::good}},
                     {fmt::format("expected failure: {}", all.expected_failures),
                      {.form = Form::bars, .tone = Tone::notable}},
                     {fmt::format("broken: {}", all.broken), {.form = Form::bars, .tone = Tone::bad}}}};
}

Result run_hard_cases(const StudyRequest& request) {
  const std::vector<PlayedCase> cases = play(cases_of(request), request);
  const std::vector<Judgement> judgements = judgements_of(cases);
  return {.tables = {verdict_table(judgements), case_table(cases)},
          .figures = {figure_of(cases, judgements)},
          .verdict = verdict_of(cases, judgements),
          .summary = {summary_of(cases)}};
}

}  // namespace

Study hard_cases_study() {
  return {.name = "hard-cases",
          .summary = "what must hold in every step, however hard the scenario",
          .takes_scenarios = true,
          .default_scenarios = "scenarios/hard",
          .run = run_hard_cases};
}

}  // namespace hyrax

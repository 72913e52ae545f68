// `hyrax-sim study hard-cases`: its tables, figure and verdict.
#include <algorithm>
#include <map>
#include <set>
#include <span>

#include <fmt/format.h>

#include "sim/core/listing_core.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/methods/many_flings.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

// As files and JSON have them.
constexpr std::array<std::string_view, 4> kVerdictNames = {"held", "finding", "broken", "finding gone"};

// One invariant that was checked in one case. Refers to the case.
struct Judgement {
  Judgement(const PlayedCase& in_case, Invariant judged)
      : played(&in_case), invariant(judged), verdict(judge(in_case, judged)) {}

  const PlayedCase* played;
  Invariant invariant;
  CaseVerdict verdict;

  [[nodiscard]] const InvariantText& text() const {
    return kInvariantTexts[static_cast<std::size_t>(invariant)];
  }
  [[nodiscard]] const InvariantMeasure& measure() const {
    return played->measures[static_cast<std::size_t>(invariant)];
  }
};

// Every invariant that was checked, case by case.
std::vector<Judgement> judgements_of(std::span<const PlayedCase> cases) {
  std::vector<Judgement> judgements;
  for (const PlayedCase& played : cases)
    for (std::size_t index = 0; index < kInvariantCount; ++index)
      if (played.measures[index].is_checked) judgements.emplace_back(played, static_cast<Invariant>(index));
  return judgements;
}

// One invariant over many cases.
struct InvariantCount {
  std::int64_t cases = 0;
  std::int64_t held = 0;
  std::int64_t expected_failures = 0;
  std::int64_t broken = 0;       // With the expected failures that did not occur.
  double slack = kNotGiven;      // The smallest of the cases in which it held.
  std::string least_slack_case;  // The first one with that slack.

  void add(const Judgement& judgement) {
    ++cases;
    const double slack_here = judgement.measure().slack;
    if (judgement.verdict == CaseVerdict::expected_failure)
      ++expected_failures;
    else if (judgement.verdict != CaseVerdict::held)
      ++broken;
    else if (++held == 1 || slack_here < slack) {
      slack = slack_here;
      least_slack_case = judgement.played->hard_case.name;
    }
  }
};

std::vector<HardCase> cases_of(const StudyRequest& request) {
  std::vector<HardCase> cases;
  for (const NamedScenario& named : request.scenarios)
    for (HardCase& hard_case :
         hard_cases_of(with_parameters(request.core, named.scenario.parameters).value(), named.scenario))
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
    const std::int64_t more = step_count(hard_case.scenario);
    const Core core = with_parameters(request.core, hard_case.scenario.parameters).value();
    played.push_back(play_hard_case(core, std::move(hard_case), [&](std::int64_t checked) {
      if (request.report_progress) request.report_progress("steps", done + checked, steps);
    }));
    done += more;
  }
  return played;
}

Table verdict_table(const std::vector<Judgement>& judgements) {
  using J = const Judgement&;
  return StudyTable("verdicts", "every case against every invariant that was checked in it", judgements)
      .add("case", "", "case", [](J j) { return j.played->hard_case.name; })
      .add("invariant", "", "what must hold", [](J j) { return j.text().name; })
      .add("verdict", "", "held, finding (an expected failure), broken, or finding gone (it holds)",
           [](J j) { return kVerdictNames[static_cast<std::size_t>(j.verdict)]; })
      .add("margin", "", "smallest margin to the bound, below 0 if broken",
           [](J j) { return j.measure().slack; })
      .add("margin_unit", "", "unit of the margin", [](J j) { return j.text().unit; })
      .add("worst_step", "1", "row number of the smallest margin",
           [](J j) { return j.measure().worst_step; });
}

Table case_table(const std::vector<PlayedCase>& cases) {
  using P = const PlayedCase&;
  return StudyTable("cases", "the cases", cases)
      .add("case", "", "case", [](P played) { return played.hard_case.name; })
      .add("made_from", "", "scenario it is, or was made from",
           [](P played) { return played.hard_case.made_from; })
      .add("why", "", "why it is hard", [](P played) { return played.hard_case.why; })
      .add("steps", "1", "steps played and checked", [](P played) { return played.summary.steps; })
      .add("knife_edges", "1", "decisions about a wall within rounding", &PlayedCase::knife_edges);
}

// The members of the JSON document.
Table summary_of(const std::vector<PlayedCase>& cases) {
  std::vector<Column> columns = case_table(cases).columns;
  std::erase_if(columns, [](const Column& column) { return column.name == "why"; });
  columns.push_back(column_of("invariants", "", "", cases, [](const PlayedCase& played) {
    std::vector<Column> verdicts = verdict_table(judgements_of({&played, 1})).columns;
    std::erase_if(verdicts,
                  [](const Column& column) { return column.name == "case" || column.name == "margin_unit"; });
    return Table{"invariants", "", std::move(verdicts), JsonForm::by_first};
  }));
  return {"cases", "", std::move(columns)};
}

Table invariant_table(const std::vector<Judgement>& judgements) {
  std::map<Invariant, InvariantCount> counts;
  for (const Judgement& judgement : judgements) counts[judgement.invariant].add(judgement);
  const auto text_of = [](const auto& each) { return kInvariantTexts[static_cast<std::size_t>(each.first)]; };
  return StudyTable("invariants", "", counts)
      .add("invariant", "", [&](const auto& each) { return text_of(each).name; })
      .add("cases", "1", [](const auto& each) { return each.second.cases; })
      .add("held", "1", [](const auto& each) { return each.second.held; })
      .add("expected_failures", "1", [](const auto& each) { return each.second.expected_failures; })
      .add("broken", "1", [](const auto& each) { return each.second.broken; })
      .add(
          "least_slack", "1", [](const auto& each) { return each.second.slack; }, 3)
      .add("unit", "",
           [&](const auto& each) {
             const std::string_view unit = text_of(each).unit;
             return unit == "1" ? "" : unit_text(std::string(unit));
           })
      .add("in_case", "", [](const auto& each) { return each.second.least_slack_case; });
}

// What the listing itself breaks in any scenario (is_broken_by_listing) is known without the case's saying
// so.
std::string expected_failure_text(const Judgement& judgement) {
  if (judgement.invariant == Invariant::comes_to_rest) return judgement.played->hard_case.never_at_rest;
  if (judgement.invariant == Invariant::stays_at_rest) return judgement.played->hard_case.thrown_at_rest;
  if (judgement.invariant == Invariant::keeps_energy)
    return "of bounces without loss each returns up to G dt less speed than it got";
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
    return fmt::format("{}: {}", head, judgement.played->broken_expectation);
  return fmt::format("{} is broken by {:.3g} {} in row {} ({})", head, -measure.slack,
                     unit_text(std::string(text.unit)), measure.worst_step, text.rule);
}

// "393 cases: none is broken, 38 fail as the listing does."
std::string answer_of(std::size_t cases, const std::vector<Judgement>& judgements) {
  std::set<const PlayedCase*> broken, failing;
  for (const Judgement& judgement : judgements)
    if (judgement.verdict == CaseVerdict::expected_failure)
      failing.insert(judgement.played);
    else if (judgement.verdict != CaseVerdict::held)
      broken.insert(judgement.played);
  return fmt::format(
      "{}: {} broken, {} as the listing itself does.", plain_counted(cases, "hard case"),
      broken.empty() ? "none is" : fmt::format("{} {}", broken.size(), broken.size() == 1 ? "is" : "are"),
      failing.size() == 1 ? "1 fails" : fmt::format("{} fail", failing.size()));
}

Verdict verdict_of(const std::vector<PlayedCase>& cases, const std::vector<Judgement>& judgements) {
  std::int64_t steps = 0, knife_edges = 0;
  for (const PlayedCase& played : cases) {
    steps += played.summary.steps;
    knife_edges += played.knife_edges;
  }
  Verdict verdict{answer_of(cases.size(), judgements),
                  {fmt::format("{}, each checked against these invariants:", counted(steps, "step")),
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
  std::vector<std::string> origins;  // In the cases' order.
  std::map<std::string, std::int64_t> members;
  std::int64_t steps = 0;
  for (const PlayedCase& played : cases) {
    if (++members[played.hard_case.made_from] == 1) origins.push_back(played.hard_case.made_from);
    steps += played.summary.steps;
  }
  InvariantCount all;
  std::map<std::pair<std::string, Invariant>, InvariantCount> counts;
  for (const Judgement& judgement : judgements) {
    all.add(judgement);
    counts[{judgement.played->hard_case.made_from, judgement.invariant}].add(judgement);
  }
  Grid grid;
  for (const InvariantText& text : kInvariantTexts) grid.columns.emplace_back(text.name, Tone::ink);
  for (const std::string& origin : origins) {
    const std::size_t row = grid.rows.size();
    grid.rows.push_back(members[origin] > 1 ? fmt::format("{} ×{}", origin, members[origin]) : origin);
    for (std::size_t column = 0; column < kInvariantCount; ++column) {
      const InvariantCount& counted = counts[{origin, static_cast<Invariant>(column)}];
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
  Result result{.tables = {verdict_table(judgements), case_table(cases)},
                .figures = {figure_of(cases, judgements)},
                .verdict = verdict_of(cases, judgements),
                .summary = {summary_of(cases)}};
  if (!request.core.constants || std::ranges::none_of(cases, &HardCase::is_lossless, &PlayedCase::hard_case))
    return result;
  result.tables.push_back(parting_table(request.core));
  result.summary.push_back(result.tables.back());
  result.verdict.text.emplace_back(fmt::format(
      "Random flings (seed {}) at 60 Hz beside others that start apart by an ulp, or by more: when their "
      "contacts part, median (95 %):",
      kFlingSeed));
  result.verdict.text.emplace_back(result.tables.back());
  return result;
}

}  // namespace

Study hard_cases_study() {
  return {.name = "hard-cases",
          .summary = "what must hold in every step, however hard the scenario",
          .needs_paper_step = false,
          .default_scenarios = "scenarios/hard",
          .run = run_hard_cases};
}

}  // namespace hyrax

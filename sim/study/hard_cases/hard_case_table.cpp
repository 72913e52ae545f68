#include "sim/study/hard_cases/hard_case_table.h"

#include <cstdio>

namespace hyrax {
namespace {

const InvariantText& text_of(Invariant invariant) {
  return kInvariantTexts[static_cast<std::size_t>(invariant)];
}

const InvariantMeasure& measure_of(const PlayedCase& played, Invariant invariant) {
  return played.result.measures[static_cast<std::size_t>(invariant)];
}

std::string broken_sentence(const PlayedCase& played, Invariant invariant) {
  const InvariantMeasure& measure = measure_of(played, invariant);
  const std::string head = played.hard_case.name + ": " + std::string(text_of(invariant).name);
  if (measure.holds) return head + " holds, which it was known not to: its finding is out of date";
  if (invariant == Invariant::expectations) return head + ": " + played.result.expectation_broken;
  char text[96];
  std::snprintf(text, sizeof text, " is broken by %.3g %s in row %lld", -measure.margin,
                text_of(invariant).unit.data(), static_cast<long long>(measure.worst_step));
  return head + text + " (" + std::string(text_of(invariant).rule) + ")";
}

template <class See>
void for_each_asked(const std::vector<PlayedCase>& cases, const See& see) {
  for (const PlayedCase& played : cases)
    for (std::size_t index = 0; index < kInvariantCount; ++index)
      if (played.result.measures[index].is_asked) see(played, static_cast<Invariant>(index));
}

}  // namespace

std::string_view name_of(CaseVerdict verdict) {
  switch (verdict) {
    case CaseVerdict::held:
      return "held";
    case CaseVerdict::finding:
      return "finding";
    case CaseVerdict::broken:
      return "broken";
    case CaseVerdict::finding_gone:
      return "finding gone";
  }
  return "";
}

Table hard_case_verdicts(const std::vector<PlayedCase>& cases) {
  std::vector<std::string> names, invariants, verdicts, units;
  std::vector<double> margins;
  std::vector<std::int64_t> worst_steps;
  for_each_asked(cases, [&](const PlayedCase& played, Invariant invariant) {
    const InvariantMeasure& measure = measure_of(played, invariant);
    names.push_back(played.hard_case.name);
    invariants.emplace_back(text_of(invariant).name);
    verdicts.emplace_back(name_of(judge(played.hard_case, played.result, invariant)));
    margins.push_back(measure.margin);
    units.emplace_back(text_of(invariant).unit);
    worst_steps.push_back(measure.worst_step);
  });
  return {"verdicts",
          "every case against every invariant asked of it",
          {{"case", "", "case", std::move(names)},
           {"invariant", "", "what must hold", std::move(invariants)},
           {"verdict", "", "held, finding (known not to hold), broken, or finding gone", std::move(verdicts)},
           {"margin", "", "smallest margin to the bound, below 0 where broken", std::move(margins)},
           {"margin_unit", "", "unit of the margin", std::move(units)},
           {"worst_step", "1", "row number of the smallest margin", std::move(worst_steps)}}};
}

Table hard_case_list(const std::vector<PlayedCase>& cases) {
  std::vector<std::string> names, origins, reasons;
  std::vector<std::int64_t> steps, edges;
  for (const PlayedCase& played : cases) {
    names.push_back(played.hard_case.name);
    origins.push_back(played.hard_case.made_from);
    reasons.push_back(played.hard_case.why);
    steps.push_back(played.result.steps);
    edges.push_back(played.result.knife_edges);
  }
  return {"cases",
          "the cases",
          {{"case", "", "case", std::move(names)},
           {"made_from", "", "scenario it is, or was made from", std::move(origins)},
           {"why", "", "why it is hard", std::move(reasons)},
           {"steps", "1", "steps played and watched", std::move(steps)},
           {"knife_edges", "1", "decisions about a wall within rounding", std::move(edges)}}};
}

InvariantSummary summarise(const std::vector<PlayedCase>& cases, Invariant invariant,
                           const std::string& made_from) {
  InvariantSummary summary;
  for (const PlayedCase& played : cases) {
    const InvariantMeasure& measure = measure_of(played, invariant);
    if (!measure.is_asked || (!made_from.empty() && played.hard_case.made_from != made_from)) continue;
    ++summary.asked;
    const CaseVerdict verdict = judge(played.hard_case, played.result, invariant);
    if (verdict == CaseVerdict::finding)
      ++summary.findings;
    else if (verdict != CaseVerdict::held)
      ++summary.broken;
    else if (++summary.held == 1 || measure.margin < summary.margin) {
      summary.margin = measure.margin;
      summary.nearest = played.hard_case.name;
    }
  }
  return summary;
}

std::vector<std::string> broken_sentences(const std::vector<PlayedCase>& cases) {
  std::vector<std::string> sentences;
  for_each_asked(cases, [&](const PlayedCase& played, Invariant invariant) {
    const CaseVerdict verdict = judge(played.hard_case, played.result, invariant);
    if (verdict == CaseVerdict::broken || verdict == CaseVerdict::finding_gone)
      sentences.push_back(broken_sentence(played, invariant));
  });
  return sentences;
}

}  // namespace hyrax

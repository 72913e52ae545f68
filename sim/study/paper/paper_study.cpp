// `hyrax-sim study paper`: its table, figure, verdict, and the comparison with expected verdicts.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/result/number_text.h"
#include "sim/study/paper/paper_claim.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

using VerdictsByClaim = std::map<std::string, std::string>;

// Time of a step of a fling that comes to rest: the shortest of many measurements, since everything else that
// runs on the machine only adds to it.
double step_time_s(const Core& core, std::int64_t (*now_ns)()) {
  constexpr std::int64_t kSteps = 2'000;
  double least_s = 1.0;
  for (int repetition = 0; repetition < 200; ++repetition) {
    const std::int64_t start_ns = now_ns();
    const State body = core.steps({100.0, 100.0, 900.0, -1200.0}, 1.0 / 60.0, {1792, 952}, kSteps);
    const double time_s = 1e-9 * static_cast<double>(now_ns() - start_ns);
    if (body.y_px >= 0.0) least_s = std::min(least_s, time_s / static_cast<double>(kSteps));
  }
  return least_s;
}

// An end of the range, NaN of a single measurement.
auto range_end(std::size_t end) {
  return [end](const Claim& claim) { return claim.range ? (*claim.range)[end] : kNotGiven; };
}

Table claim_table(const std::vector<Claim>& claims) {
  const auto verdict = [](const Claim& claim) { return name_of(claim.verdict); };
  return StudyTable("claims", "the paper's sentences against the core", claims)
      .add("claim", "", "name of the claim", &Claim::id)
      .add("section", "", "section of the paper", &Claim::section)
      .add("sentence", "", "sentence of the paper, shortened", &Claim::sentence)
      .add("measured", "", "what was measured", &Claim::measured)
      .add("expected", "", "the number, in its unit, if the sentence holds", &Claim::expected)
      .add("number", "", "the measured value; of many the median", &Claim::number)
      .add("number_low", "", "low end of the range of many values", range_end(0))
      .add("number_high", "", "high end of the range of many values", range_end(1))
      .add("number_unit", "", "unit of the number", &Claim::unit)
      .add("verdict", "", "holds, holds when, does not hold, or not measured", verdict)
      .add("remark", "", "when it holds, or what the number means", &Claim::remark);
}

// The array of the JSON document.
Table summary_of(Table claims) {
  for (Column& column : claims.columns)
    if (column.name == "number_unit") column.name = "unit";
  return claims;
}

// ERRORS: RequestRefused that names every unknown claim and verdict.
VerdictsByClaim checked_verdicts(const ExpectedVerdicts& expected, const std::vector<Claim>& claims) {
  std::string unknown, faults;
  for (const auto& [name, verdict] : expected.verdicts) {
    if (std::ranges::find(claims, name, &Claim::id) == claims.end())
      unknown += (unknown.empty() ? "" : ", ") + name;
    else if (std::ranges::find(kClaimVerdictNames, verdict) == kClaimVerdictNames.end())
      faults += fmt::format("\n{}: /verdicts/{}: unknown verdict (found {}); allowed: {}", expected.path,
                            name, verdict, fmt::join(kClaimVerdictNames, ", "));
  }
  if (!unknown.empty())
    faults +=
        fmt::format("\n{}: /verdicts: unknown claim (found {}); `hyrax-sim study paper` prints all claims",
                    expected.path, unknown);
  if (!faults.empty()) throw RequestRefused(faults.substr(1));
  return {expected.verdicts.begin(), expected.verdicts.end()};
}

std::string number_text(const Claim& claim, bool has_all_digits) {
  if (std::isnan(claim.number)) return rounded(claim.number);
  const std::string number = has_all_digits ? fmt::format("{}", claim.number) : rounded(claim.number);
  return claim.unit == "1" ? number : number + " " + unit_text(claim.unit);
}

std::vector<std::string> differences(const std::vector<Claim>& claims, const VerdictsByClaim& expected,
                                     const std::string& path) {
  std::vector<std::string> sentences;
  for (const Claim& claim : claims) {
    const auto verdict = expected.find(claim.id);
    if (verdict == expected.end())
      sentences.push_back(
          fmt::format("{}: {}, but {} has no verdict for it", claim.id, name_of(claim.verdict), path));
    else if (verdict->second != name_of(claim.verdict))
      sentences.push_back(fmt::format("{}: {}, but {} expects: {} ({}: {})", claim.id, name_of(claim.verdict),
                                      path, verdict->second, claim.measured, number_text(claim, true)));
  }
  return sentences;
}

std::string counts_text(const std::vector<Claim>& claims) {
  std::array<int, kClaimVerdictNames.size()> counts{};
  for (const Claim& claim : claims) ++counts[static_cast<std::size_t>(claim.verdict)];
  return fmt::format("{} hold, {} hold on a condition, {} do not hold", counts[0], counts[1], counts[2]) +
         (counts[3] > 0 ? fmt::format(", {} could not be measured", counts[3]) : "");
}

Verdict verdict_of(const std::vector<Claim>& claims) {
  std::string sentence = fmt::format("paper: {} claims measured: {}", claims.size(), counts_text(claims));
  const auto number = [](const Claim& claim) {
    std::string text = number_text(claim, claim.is_exact);
    if (!claim.range) return text;
    return fmt::format("{} ({} .. {})", text, rounded(claim.range->front()), rounded(claim.range->back()));
  };
  const auto verdict = [](const Claim& claim) { return name_of(claim.verdict); };
  return {{std::move(sentence), StudyTable("claims", "", claims)
                                    .add("claim", "", &Claim::id)
                                    .add("verdict", "", verdict)
                                    .add("expected", "", &Claim::expected)
                                    .add("measured", "", number)
                                    .add("remark", "", &Claim::remark)},
          {}};
}

// An expected verdict has the colour of a verdict if it differs from the measured one.
ListField expected_field(const Claim& claim, const VerdictsByClaim& expected,
                         const std::array<Tone, 4>& tones) {
  const auto verdict = expected.find(claim.id);
  if (verdict == expected.end()) return {.text = "no verdict", .fill = Tone::hairline};
  if (verdict->second == name_of(claim.verdict)) return {.text = verdict->second};
  const auto name = std::ranges::find(kClaimVerdictNames, verdict->second);
  return {.text = verdict->second,
          .fill = tones[static_cast<std::size_t>(name - kClaimVerdictNames.begin())]};
}

Figure claim_figure(const std::vector<Claim>& claims, const VerdictsByClaim* expected) {
  constexpr std::array<Tone, 4> kTones = {Tone::good, Tone::notable, Tone::bad, Tone::hairline};
  Listing listing{
      .columns = {
          {.title = "section", .width_px = 52},
          {.title = "sentence; what was measured, or when it holds", .width_px = 700, .letters_max = 106},
          {.title = "verdict", .width_px = 120},
          {.title = "measured", .width_px = 110, .is_right = true}}};
  if (expected != nullptr)
    listing.columns.insert(listing.columns.begin() + 3, {.title = "expected", .width_px = 120});
  for (const Claim& claim : claims) {
    // The condition is worth more to a reader than the measurement.
    const bool has_condition = claim.verdict == ClaimVerdict::holds_when && !claim.remark.empty();
    std::vector<ListField> row = {
        {.text = claim.section()},
        {.text = claim.sentence, .detail = has_condition ? claim.remark : claim.measured},
        {.text = std::string(name_of(claim.verdict)) + (has_condition ? " …" : ""),
         .fill = kTones[static_cast<std::size_t>(claim.verdict)]},
        {.text = number_text(claim, false)}};
    if (expected != nullptr) row.insert(row.begin() + 3, expected_field(claim, *expected, kTones));
    listing.rows.push_back(std::move(row));
  }
  return {.title = "The paper's claims, measured",
          .subtitle = "Each sentence against the core: " + counts_text(claims) +
                      (expected == nullptr ? "" : "; an expected verdict that differs is coloured"),
          .body = std::move(listing)};
}

Result run_paper(const StudyRequest& request) {
  return paper_result(paper_claims(request.core, step_time_s(request.core, request.now_ns)),
                      request.expected);
}

}  // namespace

Result paper_result(const std::vector<Claim>& claims, const std::optional<ExpectedVerdicts>& given) {
  std::optional<VerdictsByClaim> expected;
  if (given) expected = checked_verdicts(*given, claims);
  Result result{.tables = {claim_table(claims)},
                .figures = {claim_figure(claims, expected ? &*expected : nullptr)},
                .verdict = verdict_of(claims),
                .summary = {summary_of(claim_table(claims))}};
  if (expected) result.verdict.broken = differences(claims, *expected, given->path);
  return result;
}

std::vector<Claim> paper_claims(const Core& core, double step_s) {
  std::vector<Claim> claims;
  for (std::vector<Claim> some : {flight_claims(core), energy_claims(core), accuracy_claims(core),
                                  wall_claims(core), time_step_claims(core), order_claims(core),
                                  constant_claims(core), use_claims(core), speed_claims(step_s)})
    std::move(some.begin(), some.end(), std::back_inserter(claims));
  std::ranges::stable_sort(claims, {}, &Claim::section);
  return claims;
}

Study paper_study() {
  return {.name = "paper",
          .summary = "every claim of the paper, measured",
          .takes_expected = true,
          .is_of_paper = true,
          .run = run_paper};
}

}  // namespace hyrax

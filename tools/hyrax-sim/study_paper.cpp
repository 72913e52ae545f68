#include "tools/hyrax-sim/study_paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "sim/study/methods/core.h"
#include "sim/study/paper/paper_claim.h"
#include "tools/hyrax-sim/verdict_file.h"
#include "tools/report/paper_figure.h"

namespace hyrax {
namespace {

// Of a fling into rest, the shortest of many times: what else the machine does only adds.
double step_time_s() {
  constexpr std::int64_t kSteps = 2'000;
  double least_s = 1.0;
  for (int repetition = 0; repetition < 200; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    const State body = core_steps({100.0, 100.0, 900.0, -1200.0}, 1.0 / 60.0, {1792, 952}, kSteps);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (body.y_px >= 0.0) least_s = std::min(least_s, taken.count() / static_cast<double>(kSteps));
  }
  return least_s;
}

std::string number_text(const Claim& claim) {
  const std::string number =
      claim.is_exact ? fmt::format("{}", claim.number) : fmt::format("{:.4g}", claim.number);
  return claim.unit == "1" ? number : number + " " + claim.unit;
}

std::string verdict_text(const std::vector<Claim>& claims) {
  std::array<int, kClaimVerdictNames.size()> counts{};
  std::string lines;
  for (const Claim& claim : claims) {
    ++counts[static_cast<std::size_t>(claim.verdict)];
    lines += fmt::format("  {:<24} {:<14} {:>14}  {}\n", claim.id, name_of(claim.verdict), number_text(claim),
                         claim.remark);
  }
  return fmt::format("paper: {} claims measured: {} hold, {} hold on a condition, {} do not hold{}\n",
                     claims.size(), counts[0], counts[1], counts[2],
                     counts[3] > 0 ? fmt::format(", {} could not be measured", counts[3]) : std::string()) +
         lines;
}

Json::Object json_of(const std::vector<Claim>& claims) {
  Json::Array entries;
  for (const Claim& claim : claims)
    entries.push_back(Json::Object{{"claim", claim.id},
                                   {"section", claim.section()},
                                   {"sentence", claim.sentence},
                                   {"measured", claim.measured},
                                   {"number", claim.number},
                                   {"unit", claim.unit},
                                   {"verdict", name_of(claim.verdict)},
                                   {"remark", claim.remark}});
  return {{"claims", std::move(entries)}};
}

}  // namespace

StudyOutcome make_paper(const StudyRequest& request) {
  const std::vector<Claim> claims = all_claims(step_time_s());
  return {.tables = {claim_table(claims)},
          .figures = {{"", paper_figure_script(claims)}},
          .verdict = verdict_text(claims),
          .broken = request.expect_file.empty() ? std::vector<std::string>{}
                                                : unexpected_verdicts(request.expect_file, claims),
          .json = json_of(claims)};
}

}  // namespace hyrax

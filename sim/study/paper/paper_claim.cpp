#include "sim/study/paper/paper_claim.h"

#include <algorithm>

namespace hyrax {

std::vector<Claim> claims_on_speed(double step_s) {
  constexpr double kFrame_s = 1.0 / 60.0;
  constexpr double kFast = 1e-3;  // A thousandth of a frame is beyond anybody's notice.
  const double share = step_s / kFrame_s;
  return {{"7-fast", "Using C++ makes it fast",
           "time of a step, as a part of a frame of a sixtieth of a second", share, "1",
           share < kFast ? ClaimVerdict::holds : ClaimVerdict::does_not_hold, ""}};
}

std::vector<Claim> all_claims(double step_s) {
  std::vector<Claim> claims;
  for (std::vector<Claim> some :
       {claims_on_flight(), claims_on_energy(), claims_on_walls(), claims_on_rest(), claims_on_time_steps(),
        claims_on_order(), claims_on_constants(), claims_on_use(), claims_on_speed(step_s)})
    std::move(some.begin(), some.end(), std::back_inserter(claims));
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return a.section() < b.section(); });
  return claims;
}

Table claim_table(const std::vector<Claim>& claims) {
  const auto column = [&](auto field) {
    std::vector<std::string> values;
    values.reserve(claims.size());
    for (const Claim& claim : claims) values.emplace_back(field(claim));
    return values;
  };
  std::vector<double> numbers;
  numbers.reserve(claims.size());
  for (const Claim& claim : claims) numbers.push_back(claim.number);
  return {
      "claims",
      "the paper's sentences against the core",
      {{"claim", "", "name of the claim", column([](const Claim& claim) { return claim.id; })},
       {"section", "", "section of the paper", column([](const Claim& claim) { return claim.section(); })},
       {"sentence", "", "the paper's words, shortened",
        column([](const Claim& claim) { return claim.sentence; })},
       {"measured", "", "what was measured", column([](const Claim& claim) { return claim.measured; })},
       {"number", "", "what it came to", std::move(numbers)},
       {"number_unit", "", "unit of the number", column([](const Claim& claim) { return claim.unit; })},
       {"verdict", "", "holds, holds when, does not hold, or not measured",
        column([](const Claim& claim) { return std::string(name_of(claim.verdict)); })},
       {"remark", "", "when it holds, or what the number means",
        column([](const Claim& claim) { return claim.remark; })}}};
}

}  // namespace hyrax

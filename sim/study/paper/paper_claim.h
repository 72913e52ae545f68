// The paper's checkable sentences, and what measuring them came to.
//
// Source: "Use of physics in hyrax.exe". A verdict is computed from what was measured on the core at hand, so
// on a changed physics.h the same functions tell what became of each sentence.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/result/table.h"

namespace hyrax {

enum class ClaimVerdict { holds, holds_when, does_not_hold, not_measured };
inline constexpr std::array<std::string_view, 4> kClaimVerdictNames = {"holds", "holds when", "does not hold",
                                                                       "not measured"};
[[nodiscard]] inline std::string_view name_of(ClaimVerdict verdict) {
  return kClaimVerdictNames[static_cast<std::size_t>(verdict)];
}

struct Claim {
  std::string id;        ///< Section and a word, as "2.3-energy"; files of expected verdicts name it.
  std::string sentence;  ///< The paper's words, shortened.
  std::string measured;  ///< What was measured, and how.
  double number = 0.0;
  std::string unit;
  ClaimVerdict verdict = ClaimVerdict::not_measured;
  std::string remark;  ///< Of `holds when`: when. Else what the number means, where that is not plain.
  bool is_exact =
      false;  ///< The number was compared bit for bit, and is printed so that it reads back the same.

  /// "2.3" of "2.3-energy".
  [[nodiscard]] std::string section() const { return id.substr(0, id.find('-')); }
};

/// The paper's sentences on flight (section 2), walls (3), numerics (4), constants (5) and use (6).
[[nodiscard]] std::vector<Claim> claims_on_flight();
[[nodiscard]] std::vector<Claim> claims_on_energy();
[[nodiscard]] std::vector<Claim> claims_on_walls();
[[nodiscard]] std::vector<Claim> claims_on_rest();
[[nodiscard]] std::vector<Claim> claims_on_time_steps();
[[nodiscard]] std::vector<Claim> claims_on_order();
[[nodiscard]] std::vector<Claim> claims_on_constants();
[[nodiscard]] std::vector<Claim> claims_on_use();
/// The conclusion's "fast", from a step's time in s.
[[nodiscard]] std::vector<Claim> claims_on_speed(double step_s);

/// All of them, by section. @param step_s how long a step takes here.
[[nodiscard]] std::vector<Claim> all_claims(double step_s);

[[nodiscard]] Table claim_table(const std::vector<Claim>& claims);

}  // namespace hyrax

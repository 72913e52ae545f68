// The paper's checkable sentences, each with what was measured and a verdict.
//
// Source: "Use of physics in hyrax.exe". Verdicts are computed from measurements of the core, so that the
// same functions judge a changed physics.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/result.h"
#include "sim/study/study.h"

namespace hyrax {

enum class ClaimVerdict : std::uint8_t { holds, holds_when, does_not_hold, not_measured };
inline constexpr std::array<std::string_view, 4> kClaimVerdictNames = {"holds", "holds when", "does not hold",
                                                                       "not measured"};
[[nodiscard]] inline std::string_view name_of(ClaimVerdict verdict) {
  return kClaimVerdictNames[static_cast<std::size_t>(verdict)];
}

/// A remark, where nothing is measured without gravity.
inline constexpr char kNoGravity[] = "this core has no gravity";
/// A remark, where other orders of the listing's step are compared.
inline constexpr char kOrderOfOther[] = "this core's step is not the listing's, whose order could be changed";

/// What the paper says, and how it is measured.
struct Sentence {
  std::string id;        ///< Section and a word, as "2.3-energy"; the key in files of expected verdicts.
  std::string sentence;  ///< Of the paper, shortened.
  std::string measured;  ///< What was measured, and how.
  std::string expected;  ///< The number if the sentence holds: "1.2e+03", "< 1e-9".
  std::string unit = "1";
};

/// What the core does.
struct Finding {
  double number = kNotGiven;  ///< Of many measurements the median; NaN: nothing was measured.
  ClaimVerdict verdict = ClaimVerdict::not_measured;
  std::string remark =
      {};  ///< Of `holds when`: the condition. Else what the number means, if that is not plain.
  std::optional<std::array<double, 2>> range = {};  ///< Of many: 10 and 90 %; of a share: its 95 % interval.
};

struct Claim : Sentence, Finding {
  bool is_timing = false;  ///< The number is a time, which no two runs measure alike.
  bool is_exact = false;   ///< The number is compared bit for bit: it is printed with all its digits.

  /// "2.3" of "2.3-energy".
  [[nodiscard]] std::string section() const { return id.substr(0, id.find('-')); }
};

/// Random starts of claims that are measured over a hundred of them.
struct ClaimStarts {
  std::uint64_t seed = 7;
  double fastest_px_per_s = 2000.0;  ///< Of each component of the velocity.
  double slowest_hz = 15.0;          ///< Frame rate, which is doubled four times.
};
/// The claims that are measured over ClaimStarts, so that no verdict depends on one start: energy (2.3, 2.4),
/// frame rates (6.1), oscillators (2.3), order (2.4), energy drift and missed collisions (4.1).
[[nodiscard]] std::vector<Claim> energy_claims(const Core& core, const ClaimStarts& starts = {});
[[nodiscard]] Claim frame_rate_claim(const Core& core, const ClaimStarts& starts = {});
[[nodiscard]] std::vector<Claim> accuracy_claims(const Core& core, const ClaimStarts& starts = {});

/// The other claims: on flight (sections 1 to 2.3), walls (3, 5), time steps (3.2.2, 4.1, 4.2), the order of
/// operations (4.3, 6), constants (5) and use (6).
[[nodiscard]] std::vector<Claim> flight_claims(const Core& core);
[[nodiscard]] std::vector<Claim> wall_claims(const Core& core);
[[nodiscard]] std::vector<Claim> time_step_claims(const Core& core);
[[nodiscard]] std::vector<Claim> order_claims(const Core& core);
[[nodiscard]] std::vector<Claim> constant_claims(const Core& core);
[[nodiscard]] std::vector<Claim> use_claims(const Core& core);
/// The conclusion's "fast". @param step_s time of a step.
[[nodiscard]] std::vector<Claim> speed_claims(double step_s);
/// All of these, by section.
[[nodiscard]] std::vector<Claim> paper_claims(const Core& core, double step_s);

/// Tables, figures and verdict of the study. Broken: a verdict that is not the expected one. ERRORS:
/// RequestRefused that names every unknown claim and verdict.
[[nodiscard]] Result paper_result(const std::vector<Claim>& claims,
                                  const std::optional<ExpectedVerdicts>& expected);

}  // namespace hyrax

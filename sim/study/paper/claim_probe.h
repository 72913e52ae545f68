// What measuring a claim takes again and again.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "sim/scenario/split_mix64.h"
#include "sim/study/methods/core.h"
#include "sim/study/paper/paper_claim.h"

namespace hyrax {

/// The paper's desktop: bounds of 1920 x 1080 with a sprite of 128.
inline constexpr Bounds kDesktop{1792, 952};
inline constexpr double kSpriteSide_px = 128.0;
/// Far from all walls, so that only flight is seen.
inline constexpr Bounds kOpen{2'000'000'000, 2'000'000'000};
inline constexpr double kSixtieth_s = 1.0 / 60.0;

[[nodiscard]] inline ClaimVerdict holds_if(bool holds) {
  return holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
}

/// Equal but for a few roundings.
[[nodiscard]] inline bool is_close(double a, double b, double relative = 1e-12) {
  return std::fabs(a - b) <= relative * std::fmax(std::fabs(a), std::fabs(b));
}

/// A number as words carry it, four digits.
[[nodiscard]] inline std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// The shortest text that reads back as the same number.
[[nodiscard]] inline std::string exact_digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Draw `index` of `seed`, in low .. high.
[[nodiscard]] inline double drawn(std::uint64_t seed, std::uint64_t index, double low, double high) {
  return low + (high - low) * split_mix64_unit(seed, index);
}

/// Where a throw comes to lie: x after so long that nothing moves any more.
[[nodiscard]] inline State thrown(State body, double rate_hz, double duration_s, Bounds bounds = kDesktop) {
  return core_steps(body, 1.0 / rate_hz, bounds, static_cast<std::int64_t>(std::ceil(duration_s * rate_hz)));
}

/// Steps of random flings, contacts among them, in which the core is not the listing's step with the core's
/// own constants, in the paper's order, bit for bit.
[[nodiscard]] std::int64_t steps_unlike_listing(std::int64_t steps);

}  // namespace hyrax

// What several measurements of claims share.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/split_mix64.h"
#include "sim/study/methods/many_flings.h"
#include "sim/study/paper/paper_claim.h"

namespace hyrax {

inline constexpr double kSpriteSide_px = 128.0;
/// Far from all walls: flight alone.
inline constexpr Bounds kOpen{2'000'000'000, 2'000'000'000};
inline constexpr double kSixtieth_s = 1.0 / 60.0;

[[nodiscard]] inline ClaimVerdict holds_if(bool holds) {
  return holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
}

/// Equal except for rounding.
[[nodiscard]] inline bool is_close(double a, double b, double relative = 1e-12) {
  return std::fabs(a - b) <= relative * std::fmax(std::fabs(a), std::fabs(b));
}

/// A number with four digits.
[[nodiscard]] std::string digits(double value);

/// Smallest and largest of the values included.
struct Extremes {
  double least = 1e300;
  double most = -1e300;
  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// Random number `index` of `seed`, in low .. high.
[[nodiscard]] inline double random_between(std::uint64_t seed, std::uint64_t index, double low, double high) {
  return low + (high - low) * split_mix64_unit(seed, index);
}

/// A claim that is measured over many starts is measured over so many.
inline constexpr std::uint64_t kStarts = 100;

/// Throw `start` of a seed: from anywhere on the desktop, each component of the velocity up to fastest.
[[nodiscard]] State random_throw(const ClaimStarts& starts, std::uint64_t start);

[[nodiscard]] inline bool is_on_desktop(const State& body) {
  return body.x_px >= 0.0 && body.x_px <= kDesktop.right_px && body.y_px >= 0.0 &&
         body.y_px <= kDesktop.bottom_px;
}

/// With number and range of many values: the median, 10 and 90 %. REQUIRES: not empty.
[[nodiscard]] Finding finding_of(const std::vector<double>& values, ClaimVerdict verdict,
                                 std::string remark = {});

/// The state at a time after the start, or up to a frame later.
[[nodiscard]] inline State state_after(const Core& core, State body, double rate_hz, double duration_s,
                                       Bounds bounds = kDesktop) {
  return core.steps(body, 1.0 / rate_hz, bounds, static_cast<std::int64_t>(std::ceil(duration_s * rate_hz)));
}

/// Steps of random flings, some of them contacts, in which the core differs in a bit from the listing's step
/// with the core's constants.
[[nodiscard]] std::int64_t steps_that_differ_from_listing(const Core& core, std::int64_t steps);

}  // namespace hyrax

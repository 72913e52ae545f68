// What ladders of frame rates say: a table, a figure, sentences.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"

namespace hyrax {

/// At which the landing places of a fling are compared.
inline constexpr std::array<double, 18> kLandingRates_hz = {24.0,  25.0,  30.0,  48.0,  50.0,  60.0,
                                                            72.0,  75.0,  90.0,  100.0, 120.0, 144.0,
                                                            165.0, 200.0, 240.0, 360.0, 500.0, 1000.0};

/// Logarithmic, in Hz, with ticks at rates that displays have.
[[nodiscard]] inline Axis display_rate_axis(double low_hz, double high_hz) {
  Axis axis{
      .label = "display rate, Hz (logarithmic)", .is_logarithmic = true, .low = low_hz, .high = high_hz};
  for (const int rate_hz : {20, 24, 30, 40, 60, 75, 90, 120, 144, 165, 240, 360, 500, 1000})
    axis.ticks.push_back({static_cast<double>(rate_hz), std::to_string(rate_hz)});
  return axis;
}

/// Broken: faults of the runs. @param left_out further sentences. REQUIRES: a ladder; each has 60 and 240 Hz.
[[nodiscard]] Result ladder_result(const std::vector<RateLadder>& ladders,
                                   const std::vector<std::string>& left_out = {});

}  // namespace hyrax

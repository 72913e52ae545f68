// The axis of display rates that figures share.
#pragma once

#include "sim/result/figure.h"

namespace hyrax {

/// Logarithmic, in Hz, with ticks at rates that displays have.
[[nodiscard]] inline Axis display_rate_axis(double low_hz, double high_hz) {
  Axis axis{
      .label = "display rate, Hz (logarithmic)", .is_logarithmic = true, .low = low_hz, .high = high_hz};
  for (const int rate_hz : {20, 24, 30, 40, 60, 75, 90, 120, 144, 165, 240, 360, 500, 1000})
    axis.ticks.push_back({static_cast<double>(rate_hz), std::to_string(rate_hz)});
  return axis;
}

}  // namespace hyrax

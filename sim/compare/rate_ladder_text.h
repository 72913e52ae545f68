// What a ladder of frame rates says, in a sentence.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "sim/compare/rate_ladder.h"

namespace hyrax {

/// "first converges: from 125 to 250 Hz it changes by up to 8.1 px, from 1000 to 2000 Hz by up to 1 px; each
/// ..."
[[nodiscard]] inline std::string convergence_text(const RateLadder& ladder) {
  const std::vector<double>& px = ladder.doubling_px;
  if (px.front() == 0.0 && px.back() == 0.0)
    return ladder.scenario + " is the same at every rate from 125 Hz on.";
  std::string text = fmt::format(
      "{} {}: from {:g} to {:g} Hz it changes by up to {:.3g} px, from {:g} to {:g} Hz by up to {:.3g} px",
      ladder.scenario, ladder.converges() ? "converges" : "does not converge", kDoubledRates_hz.front(),
      2.0 * kDoubledRates_hz.front(), px.front(), kDoubledRates_hz.back(), kFinestRate_hz, px.back());
  const double gain = ladder.gain();
  if (ladder.converges() && std::isfinite(gain))
    text += fmt::format("; each doubling of the rate {:.2g} times less than the one before", gain);
  return text + ".";
}

}  // namespace hyrax

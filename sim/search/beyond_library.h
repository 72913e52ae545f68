// Random flings by two cores: what a changed core does beyond the scenarios of a library.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sim/core/core.h"
#include "sim/result/estimate.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Of flings by the accepted core and by the current one.
struct BeyondLibrary {
  Share other_bits;
  Share ends_elsewhere;  ///< Ends more than RestAnchor::kStill_px away.
  /// Of those: how far, in px; infinitely far where only one run stays finite.
  std::optional<Band> apart_px;
  Share other_bounces;  ///< Another number of contacts at some wall.
  Share settles_in_one;

  /// Median distance in px of the end from that of the exact fling.
  struct EndError {
    double accepted = 0.0;
    double current = 0.0;
  };
  std::optional<EndError> end_error_px;  ///< Nothing without exact flings.
  std::optional<Scenario> farthest;      ///< Of those that end elsewhere.
};

/// Where the exact fling is after so long; nothing where it is not known.
using ExactEnd = std::function<std::optional<State>(const Scenario&, double t_s)>;

/// The same on every machine. REQUIRES: flings > 0.
[[nodiscard]] BeyondLibrary measure_beyond(const Core& accepted, const Core& current, std::int64_t flings,
                                           const ExactEnd& exact_end);

}  // namespace hyrax

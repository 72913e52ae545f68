// Lines of the card that random flings give.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/card/card.h"

namespace hyrax {

/// Start of random fling `number` of a seed: its four numbers are draws 4 number .. 4 number + 3.
[[nodiscard]] State random_fling(std::uint64_t seed, std::int64_t number);

struct FlingLines {
  FlingLine random;
  EnergyLine energy;
  std::vector<ExactLine> exact;
};
/// ERRORS: CoreRefused where the candidate plays the flings differently a second time.
[[nodiscard]] FlingLines measure_flings(const ComparedCore& base, const ComparedCore& candidate,
                                        std::uint64_t seed, std::int64_t flings);

inline constexpr std::int64_t kDisplayFlings = 200;
inline constexpr std::array<double, 18> kLandingRates_hz = {24.0,  25.0,  30.0,  48.0,  50.0,  60.0,
                                                            72.0,  75.0,  90.0,  100.0, 120.0, 144.0,
                                                            165.0, 200.0, 240.0, 360.0, 500.0, 1000.0};
[[nodiscard]] DisplayLine measure_displays(const ComparedCore& base, const ComparedCore& candidate,
                                           std::uint64_t seed, std::int64_t flings);

[[nodiscard]] RestLine measure_rest(const ComparedCore& base, const ComparedCore& candidate);

[[nodiscard]] CostLine measure_cost(const ComparedCore& base, const ComparedCore& candidate,
                                    std::uint64_t seed, const NanosecondClock& now_ns);

}  // namespace hyrax

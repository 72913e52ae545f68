// The display rates at which a sprite ends on the floor in another way (sim/study/README.md), derived from
// the constants and found on the core.
//
// In (y, vy) the floor is a map. With g = drag * G * dt, b = restitution, a = drag and the threshold e:
//   0 stays 0 where b g < e;
//   the residual speed -b g / (1 + a b) stays above the threshold where b g / (1 + a b) >= e;
//   the two-cycle 0, -b g, 0 comes back to 0 where b g (1 - a b) < e.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/methods/many_flings.h"

namespace hyrax {
namespace {

// On the floor from that speed, after so many steps: the vertical speeds of two rows in a row.
std::array<double, 2> speeds_after(const Core& core, double vy_px_per_s, double rate_hz, std::int64_t steps) {
  const State row = core.steps({900.0, kDesktop.bottom_px, 0.0, vy_px_per_s}, 1.0 / rate_hz, kDesktop, steps);
  return {row.vy_px_per_s, core.step(row, 1.0 / rate_hz, kDesktop).vy_px_per_s};
}

// The rate at which `holds` changes, by bisection.
double changes_at_hz(const std::function<bool(double rate_hz)>& holds) {
  double low_hz = 1.0, high_hz = 1e5;
  const bool at_low = holds(low_hz);
  EXPECT_NE(holds(high_hz), at_low);
  for (int halving = 0; halving < 60; ++halving) {
    const double middle_hz = 0.5 * (low_hz + high_hz);
    (holds(middle_hz) == at_low ? low_hz : high_hz) = middle_hz;
  }
  return high_hz;
}

struct Boundaries {
  double zero_speed_above_hz, residual_speed_below_hz, two_cycle_above_hz;
};

Boundaries derived(const Constants& constants) {
  const double kept = constants.air_drag * constants.restitution;
  const double gain_hz = constants.air_drag * constants.gravity_px_per_s2 * constants.restitution /
                         constants.rest_threshold_px_per_s;
  return {gain_hz, gain_hz / (1.0 + kept), gain_hz * (1.0 - kept)};
}

Boundaries found(const Core& core) {
  const auto residual_px_per_s = [laws = *core.constants](double rate_hz) {
    return -laws.restitution * laws.air_drag * laws.gravity_px_per_s2 / rate_hz /
           (1.0 + laws.air_drag * laws.restitution);
  };
  return {changes_at_hz([&](double rate_hz) {
            return speeds_after(core, 0.0, rate_hz, 2) == std::array{0.0, 0.0};
          }),
          changes_at_hz([&](double rate_hz) {
            const auto [first, second] = speeds_after(core, residual_px_per_s(rate_hz), rate_hz, 1000);
            return first != 0.0 && second != 0.0;
          }),
          changes_at_hz([&](double rate_hz) {
            const auto [first, second] = speeds_after(core, 0.0, rate_hz, 1000);
            return first == 0.0 || second == 0.0;
          })};
}

TEST(RestBoundaries, AreThoseDerivedFromTheConstants) {
  for (const Constants& laws : {*shipped_core().constants, Constants{1250.0, 0.6, 0.999, 0.8, 5.0},
                                Constants{981.0, 0.3, 0.99, 1.0, 2.0}}) {
    const Core core = same_bits(laws, *shipped_core().constants) ? shipped_core() : listing_core(laws);
    const Boundaries expected = derived(laws), seen = found(core);
    EXPECT_NEAR(seen.zero_speed_above_hz, expected.zero_speed_above_hz, 1e-7);
    EXPECT_NEAR(seen.residual_speed_below_hz, expected.residual_speed_below_hz, 1e-7);
    EXPECT_NEAR(seen.two_cycle_above_hz, expected.two_cycle_above_hz, 1e-7);
  }
}

TEST(RestBoundaries, OfTheShippedCoreAreInTheDocument) {
  std::ostringstream text;
  text << std::ifstream(std::string(HYRAX_SOURCE_DIR) + "/sim/study/README.md").rdbuf();
  const auto [zero_hz, residual_hz, cycle_hz] = derived(*shipped_core().constants);
  for (const std::string& range :
       {fmt::format("above {:.2f} Hz | zero speed", zero_hz),
        fmt::format("{:.2f} .. {:.2f} Hz | two-cycle: 0", residual_hz, zero_hz),
        fmt::format("{:.2f} .. {:.2f} Hz | two-cycle or residual speed", cycle_hz, residual_hz),
        fmt::format("below {:.2f} Hz | residual speed, constant", cycle_hz)})
    EXPECT_NE(text.str().find(range), std::string::npos) << range;
}

}  // namespace
}  // namespace hyrax

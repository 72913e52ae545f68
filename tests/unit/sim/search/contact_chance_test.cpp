// The chance that contacts change, where it is known exactly; that of a whole run is in tests/cli/outputs.md.
#include "sim/search/contact_chance.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

Scenario falling(double x_px, double y_px, const Velocity& velocity, std::int64_t steps) {
  Scenario scenario;
  scenario.window = {1000, 600};
  scenario.sprite = {100, 100};
  scenario.start = {x_px, y_px};
  scenario.start_velocity = velocity;
  scenario.clock.base = FixedRate{60.0};
  scenario.length = steps;
  return scenario;
}

// One step, vx = 0: the right wall at 900 px acts if the start moves right by more than half a px, so a
// quarter of the square does; and nothing else depends on the start.
Scenario half_a_pixel_from_the_wall() { return falling(899.5, 300.0, {}, 1); }

TEST(ContactChance, HoldsTheExactChanceAsOftenAsItSays) {
  constexpr double kExact = 0.25;
  for (const double margin_px : {0.0, 0.5}) {
    int holds = 0, half_as_wide_holds = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const ContactChance chance =
          contact_chance(shipped_core(), half_a_pixel_from_the_wall(), margin_px, seed);
      EXPECT_EQ(chance.changed.of, 200);
      EXPECT_EQ(chance.drawn_part, 1.0 - margin_px * margin_px);
      holds += chance.low() <= kExact && kExact <= chance.high() ? 1 : 0;
      // The control: an interval of half the width holds it in about two thirds.
      const auto halved = [&](double end) { return 0.5 * (end + chance.chance()); };
      half_as_wide_holds += halved(chance.low()) <= kExact && kExact <= halved(chance.high()) ? 1 : 0;
    }
    EXPECT_GE(holds, 180) << "of 200, margin " << margin_px;
    EXPECT_LT(half_as_wide_holds, 160) << "of 200, margin " << margin_px;
  }
}

TEST(ContactChance, OfALongRunIsThatOfItsFirstSteps) {
  const Scenario scenario = falling(500.0, 100.0, {}, 20'001);
  EXPECT_EQ(contact_chance(shipped_core(), scenario, 0.0, 1, 1).steps, 20'000);
  EXPECT_EQ(contact_chance(shipped_core(), half_a_pixel_from_the_wall(), 0.0, 1, 1).steps, 1);
}

}  // namespace
}  // namespace hyrax

// The chance that contacts change: where it is known exactly, and against plain sampling by another
// generator.
#include "sim/search/contact_chance.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/trace_sink.h"

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

TEST(ContactChance, IsThatOfPlainSampling) {
  const auto contacts_of = [](const Scenario& scenario) {
    TraceSink trace;
    (void)replay(shipped_core(), scenario, trace);
    std::vector<int> walls;
    for (const Row& row : trace.rows()) walls.push_back(row.contact & ~kRestBit);
    return walls;
  };
  const Scenario scenario = falling(300.0, 120.0, {2400.0, -700.0}, 400);
  const auto contacts = contacts_of(scenario);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<> offset(-1.0, 1.0);
  Share changed;
  for (; changed.of < 2000; ++changed.of) {
    Scenario moved = scenario;
    moved.start = {scenario.start.x_px + offset(random), scenario.start.y_px + offset(random)};
    changed.count += contacts_of(moved) == contacts ? 0 : 1;
  }
  const ContactChance chance = contact_chance(shipped_core(), scenario, 0.0, 3, 2000);
  EXPECT_GT(chance.chance(), 0.05);
  EXPECT_LT(chance.chance(), 0.95);
  EXPECT_LE(chance.low(), changed.high());
  EXPECT_GE(chance.high(), changed.low());
}

TEST(ContactChance, OfALongRunIsThatOfItsFirstSteps) {
  const Scenario scenario = falling(500.0, 100.0, {}, 20'001);
  EXPECT_EQ(contact_chance(shipped_core(), scenario, 0.0, 1, 1).steps, 20'000);
  EXPECT_EQ(contact_chance(shipped_core(), half_a_pixel_from_the_wall(), 0.0, 1, 1).steps, 1);
}

}  // namespace
}  // namespace hyrax

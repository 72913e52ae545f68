// Random runs: the reference has no fault and the core's error is rounding.
#include <gtest/gtest.h>

#include <random>

#include "sim/reference/gsl_flight.h"
#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

struct Draw {
  explicit Draw(std::uint64_t seed) : random(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
  int integer(int low, int high) { return std::uniform_int_distribution<>(low, high)(random); }
  std::mt19937_64 random;
};

Clock random_clock(Draw& draw) {
  Clock clock;
  clock.base = FixedRate{std::pow(10.0, draw(0.5, 4.0))};
  const double dt_s = base_dt_s(clock);
  switch (draw.integer(0, 4)) {
    case 0:
      clock.jitter = Jitter{Jitter::Kind::uniform, draw(0.0, 1.0), 1};
      break;
    case 1:
      clock.jitter = Jitter{Jitter::Kind::normal, dt_s * draw(0.0, 2.0), 2};  // Many zero-length frames.
      break;
    case 2:
      clock.jitter = Jitter{Jitter::Kind::missed_frames, draw(0.0, 0.5), 3};
      break;
    default:
      break;
  }
  return clock;
}

Size random_size(Draw& draw) {
  return {draw.integer(0, draw.integer(0, 3) == 0 ? 1'000'000 : 2000), draw.integer(0, 100'000)};
}

Action random_action(Draw& draw) {
  switch (draw.integer(0, 4)) {
    case 0:
      return Fling{{draw(-3000, 3000), draw(-3000, 3000)}};
    case 1:
      return Place{{draw(-100, 2000), draw(-100, 2000)}};
    case 2:
      return Stop{};
    case 3:
      return Hitch{draw(0.0, 2.0)};
    default:
      return Resize{random_size(draw), std::nullopt};
  }
}

Scenario random_scenario(Draw& draw) {
  Scenario scenario;
  scenario.window = random_size(draw);
  scenario.sprite = {draw.integer(1, 200), draw.integer(1, 200)};
  const double far = draw.integer(0, 5) == 0 ? 1e12 : 3000.0;
  scenario.start = {draw(-far, far), draw(-far, far)};
  scenario.start_velocity = {draw(-far, far), draw(-far, far)};
  if (draw.integer(0, 3) == 0) scenario.start_velocity.vx_px_per_s = 0.0;
  scenario.clock = random_clock(draw);
  scenario.length = std::int64_t{1000};
  for (std::int64_t frame = draw.integer(0, 400); frame < 1000; frame += draw.integer(1, 400))
    scenario.events.push_back({frame, random_action(draw)});
  return scenario;
}

TEST(AnyRun, HasNoFaultOfTheReference) {
  Draw draw(6);
  GslFlight gsl;
  for (int i = 0; i < 300; ++i) {
    Measured measured;
    measure(random_scenario(draw), measured, &gsl);
    EXPECT_EQ(measured.summary.reference_faults, 0) << i;
    EXPECT_EQ(measured.summary.differing_steps, 0) << i;
  }
}

TEST(AnyRun, FollowsTheDiscreteClosedFormToRounding) {
  Draw draw(7);
  for (int i = 0; i < 300; ++i) {
    Measured measured;
    measure(random_scenario(draw), measured);
    for (const ArcErrors& arc : measured.arcs)
      EXPECT_LT(arc.implementation_px, 1e-8 + 1e-12 * arc.coordinate_largest_px)
          << i << ", " << arc.first_step;
  }
}

}  // namespace
}  // namespace hyrax

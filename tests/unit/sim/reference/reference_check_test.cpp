// Controls: each of these mistakes in the closed forms is noticed by the second solution.
#include "sim/reference/arc_meter.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string_view>

#include "sim/reference/arc_solution.h"
#include "sim/reference/gsl_flight.h"

namespace hyrax {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kGravity = 1200.0;
constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kHeight_px = 500.0;

// What the closed forms say of an arc, as it is handed to the check; a test changes it.
struct Closed {
  std::function<void(Flight&)> flight = [](Flight&) {};
  double height_sign = 1.0;       // In the energy.
  double gain_height_sign = 1.0;  // In its change.
  double model_rate_hz = 60.0;
  double air_drag = 0.999;
  double thrown_px_per_s = -600.0;
  double clamped_dt_s = kFrame_s;
  std::function<void(std::optional<Impact>&)> impact = [](std::optional<Impact>&) {};
};

double kinetic(const Flight& flight) {
  return 0.5 * (flight.vx_px_per_s * flight.vx_px_per_s + flight.vy_px_per_s * flight.vy_px_per_s);
}

// A throw up from the floor and to the right, until it comes down again.
std::string_view fault_of(const Closed& closed) {
  ArcStart start{.row = {.y_px = kHeight_px, .vx_px_per_s = 300.0, .vy_px_per_s = closed.thrown_px_per_s},
                 .bounds = {1000.0, kHeight_px}};
  const Model model{.air_drag = closed.air_drag};
  GslFlight gsl({}, model);
  ReferenceCheck check(model, gsl);
  ArcSolution solution({.air_drag = closed.air_drag, .model_rate_hz = closed.model_rate_hz});
  WallWatch walls(kGravity, solution.log_air_drag(), time_of_impact);
  const Flight first{0.0, 0.0, start.row.vx_px_per_s, start.row.vy_px_per_s};
  solution.start({first.vx_px_per_s, first.vy_px_per_s}, true);
  walls.start(start);
  check.start(start, true, kinetic(first));
  for (int frame = 0; frame < 59; ++frame) {
    solution.advance(kFrame_s);
    Flight flight = solution.matched();
    closed.flight(flight);
    const double rise = -kGravity * flight.dy_px;
    check.check_row({flight, kinetic(flight) + closed.height_sign * rise,
                     kinetic(flight) - kinetic(first) + closed.gain_height_sign * rise},
                    kFrame_s, solution.elapsed_s());
    walls.add(flight, kFrame_s, solution.elapsed_s());
  }
  check.check_model(solution.model(), solution.elapsed_s());
  std::optional<Impact> impact = walls.impact(Wall::ground, closed.clamped_dt_s);
  closed.impact(impact);
  check.check_impact(Wall::ground, closed.clamped_dt_s, impact);
  return check.fault(kHeight_px);
}

TEST(ReferenceCheck, AgreesWithTheClosedForms) {
  for (const double air_drag : {0.5, 0.9, 0.99, 0.997, 0.998, 0.999, 1.0 - 1e-5, 1.0 - 1e-9, 1.0}) {
    EXPECT_EQ(fault_of({.air_drag = air_drag}), "") << air_drag;
    EXPECT_EQ(fault_of({.height_sign = 1.0 + 1e-6, .air_drag = air_drag}), "energy differs") << air_drag;
  }
}

TEST(ReferenceCheck, NoticesEachMistake) {
  EXPECT_EQ(fault_of({.flight = [](Flight& flight) { flight.dy_px = kNaN; }}), "position differs");
  EXPECT_EQ(fault_of({.flight = [](Flight& flight) { flight.dx_px = kNaN; }}), "position differs");
  // Of gravity alone: a thousandth of what the speed has gained.
  const auto gains_more = [](Flight& flight) { flight.vy_px_per_s += 0.001 * (flight.vy_px_per_s + 600.0); };
  EXPECT_EQ(fault_of({.flight = gains_more}), "velocity differs");
  void (*const impacts[])(std::optional<Impact>&) = {
      [](std::optional<Impact>& impact) { impact.value().t_s *= 1.001; },
      [](std::optional<Impact>& impact) { impact.value().t_s = kNaN; },
      [](std::optional<Impact>& impact) { impact.reset(); },
      [](std::optional<Impact>& impact) { impact.value().speed_px_per_s *= 1.001; }};
  for (const auto& impact : impacts) EXPECT_EQ(fault_of({.impact = impact}), "time of impact differs");
  EXPECT_EQ(fault_of({.model_rate_hz = 60.6}), "model error differs");
  EXPECT_EQ(fault_of({.height_sign = -1.0}), "energy differs");
  EXPECT_EQ(fault_of({.gain_height_sign = -1.0}), "energy differs");
}

// As after minutes of suspend: between the last row and the ground it rises up to 1e7 px.
TEST(ReferenceCheck, MeasuresALongClampedFrameByTheWayFlownInIt) {
  for (int number = 0; number < 60; ++number) {
    Closed closed{.thrown_px_per_s = -2.5e5 - 997.0 * number, .clamped_dt_s = 600.0};
    EXPECT_EQ(fault_of(closed), "") << closed.thrown_px_per_s << " px/s";
    closed.impact = [](std::optional<Impact>& impact) { impact.value().t_s *= 1.0 + 1e-11; };
    EXPECT_EQ(fault_of(closed), "time of impact differs") << closed.thrown_px_per_s << " px/s";
    closed.impact = [](std::optional<Impact>& impact) { impact.value().t_s = HUGE_VAL; };
    EXPECT_EQ(fault_of(closed), "time of impact differs") << closed.thrown_px_per_s << " px/s";
  }
}

}  // namespace
}  // namespace hyrax

// Every kernel that this machine can run, against physics::update: states at and beside every edge.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/ensemble/lanes.h"
#include "sim/motion/state.h"
#include "sim/physics/physics.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

std::vector<double> beside(double value) {
  return {std::nextafter(value, -kInfinity), value, std::nextafter(value, kInfinity)};
}

std::vector<double> edge_positions(double bound_px) {
  std::vector<double> all = {0.0,   -0.0,   kTiny,     -kTiny,     1.0, 0.5 * bound_px, -1.0, bound_px + 1.0,
                             1e300, -1e300, kInfinity, -kInfinity, kNaN};
  for (const double edge : {bound_px, bound_px - 0.5})
    for (const double value : beside(edge)) all.push_back(value);
  return all;
}

std::vector<double> edge_speeds() {
  std::vector<double> all = {0.0,   -0.0,   kTiny, -kTiny, 1e-310, 1.0,       -1.0,       20.0, -20.0,
                             700.0, -700.0, 1e12,  -1e12,  1e300,  kInfinity, -kInfinity, kNaN, -7.4953};
  for (const double edge : {5.0, -5.0, 5.0 / 0.6, -5.0 / 0.6})
    for (const double value : beside(edge)) all.push_back(value);
  return all;
}

struct Start {
  State state;
  Size window;
};

// A NaN equals any other.
bool is_same(const State& a, const State& b) {
  const auto agree = [](double p, double q) { return same_bits(p, q) || (std::isnan(p) && std::isnan(q)); };
  return agree(a.x_px, b.x_px) && agree(a.y_px, b.y_px) && agree(a.vx_px_per_s, b.vx_px_per_s) &&
         agree(a.vy_px_per_s, b.vy_px_per_s);
}

constexpr Size kSprite{128, 128};

// In x and y at once: every pair of a position with a speed.
std::vector<Start> edge_grid() {
  std::vector<Start> starts;
  for (const Size& window : {Size{1920, 1080}, Size{128, 128}, Size{100, 60}, Size{129, 1000}}) {
    const Bounds bounds = bounds_of(window, kSprite);
    const std::vector<double> xs = edge_positions(bounds.right_px);
    const std::vector<double> ys = edge_positions(bounds.bottom_px);
    const std::vector<double> speeds = edge_speeds();
    for (std::size_t position = 0; position < xs.size(); ++position)
      for (std::size_t speed = 0; speed < speeds.size(); ++speed) {
        const std::size_t other = (speed + position) % speeds.size();
        starts.push_back(
            {{xs[position], ys[xs.size() - 1 - position], speeds[speed], speeds[other]}, window});
        starts.push_back({{xs[position], ys[position], speeds[other], speeds[speed]}, window});
      }
  }
  while (starts.size() % kLanes != 0) starts.push_back(starts.front());
  return starts;
}

State updated(const Start& start, double dt_s, std::int64_t steps) {
  physics body(start.state.x_px, start.state.y_px, start.state.vx_px_per_s, start.state.vy_px_per_s);
  for (std::int64_t step = 0; step < steps; ++step)
    body.update(dt_s, start.window.width_px, start.window.height_px, kSprite.width_px, kSprite.height_px);
  return {body.x(), body.y(), body.vx(), body.vy()};
}

State state_in(const Lanes& lanes, std::size_t lane) {
  return {lanes.x_px[lane], lanes.y_px[lane], lanes.vx_px_per_s[lane], lanes.vy_px_per_s[lane]};
}

void load(Lanes& lanes, std::size_t lane, const Start& start, double dt_s) {
  const Bounds bounds = bounds_of(start.window, kSprite);
  lanes.x_px[lane] = start.state.x_px;
  lanes.y_px[lane] = start.state.y_px;
  lanes.vx_px_per_s[lane] = start.state.vx_px_per_s;
  lanes.vy_px_per_s[lane] = start.state.vy_px_per_s;
  lanes.right_px[lane] = bounds.right_px;
  lanes.bottom_px[lane] = bounds.bottom_px;
  lanes.dt_s[lane] = dt_s;
}

TEST(Kernels, MoveAsUpdateDoes) {
  const std::vector<Start> starts = edge_grid();
  ASSERT_GT(starts.size(), 2000u);
  for (const std::int64_t steps : {1, 2, 3, 7, 120})
    for (const double dt_s : {1.0 / 60.0, 1.0 / 144.0, 0.0, 0.5}) {
      std::vector<State> expected;
      for (const Start& start : starts) expected.push_back(updated(start, dt_s, steps));
      for (const KernelSet& kernels : kernel_sets())
        for (const Detail detail : {Detail::final, Detail::tracked, Detail::extremes}) {
          int different = 0;
          for (std::size_t first = 0; first < starts.size(); first += kLanes) {
            Lanes lanes{};
            lanes.constants = *shipped_core().constants;
            for (std::size_t lane = 0; lane < kLanes; ++lane) load(lanes, lane, starts[first + lane], dt_s);
            kernels.play(lanes, steps, detail, LaneClock::fixed);
            for (std::size_t lane = 0; lane < kLanes; ++lane)
              different += is_same(state_in(lanes, lane), expected[first + lane]) ? 0 : 1;
          }
          EXPECT_EQ(different, 0) << kernels.name << ", " << steps << " steps of " << dt_s << " s";
        }
    }
}

TEST(Kernels, AreAlwaysThereAndHaveNames) {
  ASSERT_FALSE(kernel_sets().empty());
  EXPECT_STREQ(kernel_sets().back().name, "baseline");
  for (const KernelSet& kernels : kernel_sets()) std::printf("%s\n", kernels.name);
}

}  // namespace
}  // namespace hyrax

// physics::update against the listing, bit for bit, over an edge grid and over random steps.
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "sim/physics/physics.h"
#include "sim/scenario/split_mix64.h"
#include "tests/unit/sim/physics/listing.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();

struct Sizes {
  int screen_w, screen_h, obj_w, obj_h;
};

struct Step {
  double x, y, vx, vy, dt;
  Sizes sizes;
};

// A NaN stays a NaN; which one is the compiler's and the machine's choice.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

template <Slip kSlip>
bool agrees(const Step& step) {
  const Sizes& sizes = step.sizes;
  physics core(step.x, step.y, step.vx, step.vy);
  ListingBody<kSlip> listing{step.x, step.y, step.vx, step.vy};
  core.update(step.dt, sizes.screen_w, sizes.screen_h, sizes.obj_w, sizes.obj_h);
  listing.update(step.dt, sizes.screen_w, sizes.screen_h, sizes.obj_w, sizes.obj_h);
  return same(core.x(), listing.x) && same(core.y(), listing.y) && same(core.vx(), listing.vx) &&
         same(core.vy(), listing.vy);
}

std::string shown(const Step& step) {
  std::ostringstream text;
  text << std::hexfloat << "x " << step.x << " y " << step.y << " vx " << step.vx << " vy " << step.vy
       << " dt " << step.dt << std::dec << " window " << step.sizes.screen_w << " x " << step.sizes.screen_h
       << " sprite " << step.sizes.obj_w << " x " << step.sizes.obj_h;
  return text.str();
}

// A value and its neighbours one ulp below and above.
void add_with_neighbours(std::vector<double>& values, double value) {
  values.insert(values.end(), {std::nextafter(value, -kInfinity), value, std::nextafter(value, kInfinity)});
}

std::vector<double> edge_positions(double bound) {
  std::vector<double> values = {-0.0,        DBL_MIN,   -DBL_MIN,   0x0.8p-1022, 1.0,   -1.0,
                                0.5 * bound, -3000.0,   3000.0,     1e12,        -1e12, 1e300,
                                -1e300,      kInfinity, -kInfinity, kNaN};
  add_with_neighbours(values, 0.0);
  add_with_neighbours(values, bound);
  return values;
}

std::vector<double> edge_speeds() {
  std::vector<double> values = {0.0,   -0.0,   kSubnormal, -kSubnormal, DBL_MIN, -DBL_MIN,
                                1.0,   -1.0,   1234.5,     -987.6,      1e12,    -1e12,
                                1e300, -1e300, kInfinity,  -kInfinity,  kNaN};
  // Speeds that a bounce turns into the rest threshold, just above it and just below: at dt = 0 the
  // one that becomes exactly 5 is within a few ulps of 5 / (0.999 * 0.6).
  double speed = 5.0 / (0.999 * 0.6);
  for (int ulp = 0; ulp < 4; ++ulp) speed = std::nextafter(speed, 0.0);
  for (int ulp = 0; ulp < 9; ++ulp, speed = std::nextafter(speed, kInfinity)) {
    values.push_back(speed);
    values.push_back(-speed);
  }
  return values;
}

const std::vector<double> kEdgeSteps_s = {0.0,         -0.0, kSubnormal, 1e-9, 0x1.1111111111111p-6,
                                          1.0 / 144.0, 0.5,  1e6,        1e9};

// Roomy, sprite as large as the window, sprite larger, no window at all, one side larger.
const std::vector<Sizes> kEdgeSizes = {{1920, 1080, 128, 128},       {128, 96, 128, 96},
                                       {100, 50, 128, 128},          {0, 0, 1, 1},
                                       {0, 0, 1'000'000, 1'000'000}, {1'000'000, 50, 1, 128}};

// The axes meet only at the ground, where friction acts on vx: so one axis runs through all its
// edges while the other is in flight, on a bound or beyond it.
template <class Visit>
void for_each_edge_step(const Visit& visit) {
  const std::vector<double> speeds = edge_speeds();
  for (const Sizes& sizes : kEdgeSizes) {
    const double right = sizes.screen_w - sizes.obj_w;
    const double bottom = sizes.screen_h - sizes.obj_h;
    for (const double dt : kEdgeSteps_s)
      for (const double speed : speeds) {
        for (const double other : {0.5 * bottom, bottom, bottom + 1.0, -1.0, kNaN})
          for (const double x : edge_positions(right))
            for (const double vy : {-300.0, 20.0}) visit(Step{x, other, speed, vy, dt, sizes});
        for (const double other : {0.5 * right, right + 1.0, -1.0})
          for (const double y : edge_positions(bottom)) visit(Step{other, y, 77.7, speed, dt, sizes});
      }
  }
}

// A step from a state anywhere in and around the window, by draws 8 * index .. of one seed.
Step random_step(std::uint64_t index) {
  const auto draw = [index](std::uint64_t k) { return split_mix64_unit(2026, 8 * index + k); };
  const Sizes sizes = kEdgeSizes[split_mix64(7, index) % kEdgeSizes.size()];
  return {.x = (2.0 * draw(0) - 0.5) * sizes.screen_w,
          .y = (2.0 * draw(1) - 0.5) * sizes.screen_h,
          .vx = 6000.0 * (draw(2) - 0.5),
          .vy = 6000.0 * (draw(3) - 0.5),
          .dt = draw(4) < 0.9 ? 0.05 * draw(5) : 10.0 * draw(5),
          .sizes = sizes};
}

template <Slip kSlip>
std::int64_t count_differing_edge_steps() {
  std::int64_t differing = 0;
  for_each_edge_step([&](const Step& step) { differing += agrees<kSlip>(step) ? 0 : 1; });
  return differing;
}

TEST(PhysicsUpdate, AgreesWithTheListingAtEveryEdge) {
  for_each_edge_step([](const Step& step) {
    if (!agrees<Slip::none>(step)) ADD_FAILURE() << shown(step);
  });
}

TEST(PhysicsUpdate, AgreesWithTheListingOverAMillionRandomSteps) {
  for (std::uint64_t index = 0; index < 1'000'000; ++index) {
    const Step step = random_step(index);
    ASSERT_TRUE(agrees<Slip::none>(step)) << shown(step);
  }
}

TEST(PhysicsUpdate, AgreesWithTheListingOverALongRun) {
  physics core(300.0, 500.0, 2400.0, -700.0);
  ListingBody<> listing{300.0, 500.0, 2400.0, -700.0};
  for (int frame = 0; frame < 100'000; ++frame) {
    core.update(1.0 / 60.0, 1920, 1080, 128, 128);
    listing.update(1.0 / 60.0, 1920, 1080, 128, 128);
    ASSERT_TRUE(same(core.x(), listing.x) && same(core.y(), listing.y) && same(core.vx(), listing.vx) &&
                same(core.vy(), listing.vy))
        << "frame " << frame;
  }
}

template <int... kSlips>
std::vector<std::int64_t> steps_that_differ_with(std::integer_sequence<int, kSlips...>) {
  return {count_differing_edge_steps<static_cast<Slip>(kSlips + 1)>()...};
}

// Controls: each slip changes the result at the edges, so the comparison would find it in the core.
TEST(PhysicsUpdate, EachSlipOfTheListingIsSeen) {
  constexpr int kLast = static_cast<int>(Slip::rest_without_fabs);
  const std::vector<std::int64_t> differing =
      steps_that_differ_with(std::make_integer_sequence<int, kLast>());
  for (std::size_t slip = 0; slip < differing.size(); ++slip) EXPECT_GT(differing[slip], 0) << slip + 1;
}

}  // namespace
}  // namespace hyrax

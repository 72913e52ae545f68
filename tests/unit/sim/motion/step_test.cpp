// The parametrised step is physics::update bit for bit where nothing is left out.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/motion/step.h"
#include "sim/physics/physics.h"
#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

constexpr Constants kPaper{physics::GRAVITY, physics::RESTITUTION, physics::AIR_DRAG,
                           physics::GROUND_FRICTION, physics::REST_THRESHOLD};

physics core_of(const State& m) { return {m.x_px, m.y_px, m.vx_px_per_s, m.vy_px_per_s}; }

bool same_state(const State& m, const physics& core) {
  // Any NaN is as good as any other: which of two survives an operation is the compiler's choice.
  const auto same = [](double a, double b) { return same_bits(a, b) || (a != a && b != b); };
  return same(m.x_px, core.x()) && same(m.y_px, core.y()) && same(m.vx_px_per_s, core.vx()) &&
         same(m.vy_px_per_s, core.vy());
}

template <class PartSet>
auto step_with(const PartSet& parts) {
  return [parts](State& state, double dt_s, const Bounds& bounds) {
    ListingStep(kPaper, parts, bounds)(state, dt_s);
  };
}

// One step of both from the same state.
template <class Step>
bool agrees(const State& start, double dt_s, const World& world, const Step& step) {
  State variant = start;
  physics core = core_of(start);
  step(variant, dt_s, world.bounds());
  core.update(dt_s, world.window.width_px, world.window.height_px, world.sprite.width_px,
              world.sprite.height_px);
  return same_state(variant, core);
}

double below(double value) { return std::nextafter(value, -HUGE_VAL); }
double above(double value) { return std::nextafter(value, HUGE_VAL); }

// States on, one ulp beside, and far from every bound that the step compares with.
template <class Visit>
void visit_edges(const Visit& visit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const World worlds[] = {{.state = {}, .window = {1920, 1080}, .sprite = {128, 128}},
                          {.state = {}, .window = {128, 128}, .sprite = {128, 128}},
                          {.state = {}, .window = {100, 60}, .sprite = {128, 128}},
                          {.state = {}, .window = {0, 0}, .sprite = {1, 1}}};
  const double rest = 5.0 / (0.999 * 0.6);  // A bounce at dt = 0 leaves exactly 5.
  for (const World& world : worlds)
    for (const double dt_s : {0.0, kTiny, 1.0 / 60.0, 0.5, 1e6})
      for (const double x_px : {-0.0, 0.0, -kTiny, below(world.bounds().right_px), world.bounds().right_px,
                                above(world.bounds().right_px), -1e12, 1e12, std::nan("")})
        for (const double y_px :
             {-0.0, 0.0, -kTiny, below(world.bounds().bottom_px), world.bounds().bottom_px,
              above(world.bounds().bottom_px), -1e12, 1e12, std::nan("")})
          for (const double vx_px_per_s : {-0.0, 0.0, kTiny, -7.5, 1e12, kInfinity})
            for (const double vy_px_per_s :
                 {-0.0, 0.0, -1200.0 / 60.0, rest, below(rest), above(rest), -rest, 900.0, -1e12, kInfinity})
              visit(State{x_px, y_px, vx_px_per_s, vy_px_per_s}, dt_s, world);
}

TEST(SameBits, OfConstantsAreThoseOfEachOne) {
  EXPECT_TRUE(same_bits(kPaper, kPaper));
  for (double Constants::*const each :
       {&Constants::gravity_px_per_s2, &Constants::restitution, &Constants::air_drag,
        &Constants::ground_friction, &Constants::rest_threshold_px_per_s}) {
    Constants other = kPaper;
    other.*each = above(other.*each);
    EXPECT_FALSE(same_bits(kPaper, other));
  }
}

TEST(ListingStep, WithAllPartsIsTheCoreOnEveryEdge) {
  visit_edges([](const State& start, double dt_s, const World& world) {
    ASSERT_TRUE(agrees(start, dt_s, world, step_with(AllParts())));
    ASSERT_TRUE(agrees(start, dt_s, world, step_with(ModelParts())));
  });
}

TEST(ListingStep, WithAllPartsIsTheCoreThroughRandomFlings) {
  for (std::uint64_t fling = 0; fling < 300; ++fling) {
    const auto draw = [&, k = fling * 8](double low, double high) mutable {
      return low + (high - low) * split_mix64_unit(42, k++);
    };
    auto next = draw;
    const World world{.state = {},
                      .window = {static_cast<std::int32_t>(next(1.0, 2000.0)),
                                 static_cast<std::int32_t>(next(1.0, 2000.0))},
                      .sprite = {128, 128}};
    State variant{next(-500.0, 2500.0), next(-500.0, 2500.0), next(-5000.0, 5000.0), next(-5000.0, 5000.0)};
    const double dt_s = 1.0 / next(20.0, 1000.0);
    physics core = core_of(variant);
    const ModelParts parts;
    for (int frame = 0; frame < 400; ++frame) {
      ListingStep(kPaper, parts, world.bounds())(variant, dt_s);
      core.update(dt_s, world.window.width_px, world.window.height_px, 128, 128);
      ASSERT_TRUE(same_state(variant, core)) << "fling " << fling << ", frame " << frame;
    }
  }
}

TEST(ListingStep, WithoutAPartWhenCompiledIsTheSameAsWhenRun) {
  visit_edges([](const State& start, double dt_s, const World& world) {
    State compiled = start;
    State run = start;
    ModelParts parts;
    parts.leave_out(ModelPart::restitution);
    ListingStep(kPaper, AllBut<ModelPart::restitution>(), world.bounds())(compiled, dt_s);
    ListingStep(kPaper, parts, world.bounds())(run, dt_s);
    ASSERT_TRUE(same_state(compiled, core_of(run)));
  });
}

}  // namespace
}  // namespace hyrax

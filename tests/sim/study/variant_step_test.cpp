// The step with parts that can be left out is physics::update bit for bit where none is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/physics/physics.h"
#include "sim/scenario/split_mix64.h"
#include "sim/study/variant_step.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

physics core_of(const Motion& m) { return {m.x_px, m.y_px, m.vx_px_per_s, m.vy_px_per_s}; }

bool same_state(const Motion& m, const physics& core) {
  // Any NaN is as good as any other: which of two survives an operation is the compiler's choice.
  const auto same = [](double a, double b) { return same_bits(a, b) || (a != a && b != b); };
  return same(m.x_px, core.x()) && same(m.y_px, core.y()) && same(m.vx_px_per_s, core.vx()) &&
         same(m.vy_px_per_s, core.vy());
}

// One step of both from the same state.
template <class PartSet>
bool agrees(const Motion& start, double dt_s, const Room& room, const PartSet& parts) {
  Motion variant = start;
  physics core = core_of(start);
  step(variant, dt_s, room, parts);
  core.update(dt_s, room.window.width_px, room.window.height_px, room.sprite.width_px, room.sprite.height_px);
  return same_state(variant, core);
}

double below(double value) { return std::nextafter(value, -HUGE_VAL); }
double above(double value) { return std::nextafter(value, HUGE_VAL); }

// States on, one ulp beside, and far from every bound that a comparison of the step looks at.
template <class Visit>
void visit_edges(const Visit& visit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const Room rooms[] = {
      {{1920, 1080}, {128, 128}}, {{128, 128}, {128, 128}}, {{100, 60}, {128, 128}}, {{0, 0}, {1, 1}}};
  for (const Room& room : rooms)
    for (const double dt_s : {0.0, kTiny, 1.0 / 60.0, 0.5, 1e6})
      for (const double x_px : {-0.0, 0.0, -kTiny, below(room.right_px()), room.right_px(),
                                above(room.right_px()), -1e12, 1e12, std::nan("")})
        for (const double y_px : {-0.0, 0.0, -kTiny, below(room.bottom_px()), room.bottom_px(),
                                  above(room.bottom_px()), -1e12, 1e12})
          for (const double vx_px_per_s : {-0.0, 0.0, kTiny, -7.5, 1e12, kInfinity})
            for (const double vy_px_per_s :
                 {-0.0, 0.0, -1200.0 / 60.0, 5.0 / 0.6, below(5.0 / 0.6), 900.0, -1e12})
              visit(Motion{x_px, y_px, vx_px_per_s, vy_px_per_s}, dt_s, room);
}

TEST(VariantStep, WithAllPartsIsTheCoreOnEveryEdge) {
  visit_edges([](const Motion& start, double dt_s, const Room& room) {
    ASSERT_TRUE(agrees(start, dt_s, room, AllParts()));
    ASSERT_TRUE(agrees(start, dt_s, room, Parts()));
  });
}

TEST(VariantStep, WithAllPartsIsTheCoreThroughRandomFlings) {
  for (std::uint64_t fling = 0; fling < 300; ++fling) {
    const auto draw = [&, k = fling * 8](double low, double high) mutable {
      return low + (high - low) * split_mix64_unit(42, k++);
    };
    auto next = draw;
    const Room room{
        {static_cast<std::int32_t>(next(1.0, 2000.0)), static_cast<std::int32_t>(next(1.0, 2000.0))},
        {128, 128}};
    Motion variant{next(-500.0, 2500.0), next(-500.0, 2500.0), next(-5000.0, 5000.0), next(-5000.0, 5000.0)};
    const double dt_s = 1.0 / next(20.0, 1000.0);
    physics core = core_of(variant);
    const Parts parts;
    for (int frame = 0; frame < 400; ++frame) {
      step(variant, dt_s, room, parts);
      core.update(dt_s, room.window.width_px, room.window.height_px, 128, 128);
      ASSERT_TRUE(same_state(variant, core)) << "fling " << fling << ", frame " << frame;
    }
  }
}

TEST(VariantStep, WithoutAnyOnePartIsNotTheCore) {
  for (std::size_t part = 0; part < kPartCount; ++part) {
    Parts parts;
    parts.leave_out(static_cast<Part>(part));
    std::size_t differ = 0;
    visit_edges([&](const Motion& start, double dt_s, const Room& room) {
      differ += !agrees(start, dt_s, room, parts);
    });
    EXPECT_GT(differ, 0u) << kPartNames[part];
  }
}

TEST(VariantStep, WithoutAPartWhenCompiledIsTheSameAsWhenRun) {
  visit_edges([](const Motion& start, double dt_s, const Room& room) {
    Motion compiled = start;
    Motion run = start;
    Parts parts;
    parts.leave_out(Part::restitution);
    step(compiled, dt_s, room, AllBut<Part::restitution>());
    step(run, dt_s, room, parts);
    ASSERT_TRUE(same_state(compiled, core_of(run)));
  });
}

}  // namespace
}  // namespace hyrax

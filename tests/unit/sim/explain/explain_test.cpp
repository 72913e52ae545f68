// Runs of a core that somebody edited are put down to the edit, or to nothing.
#include <gtest/gtest.h>

#include <deque>

#include "sim/explain/explain.h"
#include "tests/unit/sim/explain/hand_step.h"

namespace hyrax {
namespace {

// Scenarios that meet all walls, come to rest, and have inputs and uneven frames; one is kept as blocks.
std::vector<Scenario> library() {
  Scenario low = fling_at(144.0, 1500);
  low.start = {900.0, 900.0};
  low.start_velocity = {-700.0, 0.0};
  Scenario corner = fling_at(60.0, 300);
  corner.start_velocity = {-4000.0, -4000.0};
  return {fling_at(60.0, 900), eventful_fling(), corner, low, fling_at(240.0, 12000), any_fling(3, 600)};
}

// What is explained of the library, played with the step; `golden` has the listing's runs.
struct Explained {
  std::vector<CauseGroup> groups;
  std::size_t differing = 0;

  [[nodiscard]] const Cause& first() const { return groups.at(0).cause; }
  [[nodiscard]] std::size_t explained() const {
    std::size_t runs = 0;
    for (const CauseGroup& group : groups)
      if (group.cause.kind != CauseKind::unknown) runs += group.runs.size();
    return runs;
  }
};

Explained explain_library(const HandStep& step) {
  std::deque<StoredRun> kept;
  std::vector<DifferingRun> differing;
  for (const Scenario& scenario : library()) {
    const StoredRun& golden = kept.emplace_back(run_of(scenario));
    const StoredRun& fresh = kept.emplace_back(run_of(scenario, step));
    if (golden.state_hash != fresh.state_hash) differing.push_back({golden, fresh, ""});
  }
  const KernelOf<HandCores> kernel(HandCores{&step});
  return {explain(differing, kernel), differing.size()};
}

void expect_one_cause(const HandStep& step, std::string_view operation, CauseKind kind,
                      const std::string& detail) {
  const Explained found = explain_library(step);
  ASSERT_GT(found.differing, 0u);
  ASSERT_EQ(found.groups.size(), 1u) << found.groups.at(1).cause.detail;
  EXPECT_EQ(found.first().operation, operation) << found.first().detail;
  EXPECT_EQ(name_of(found.first().kind), name_of(kind)) << found.first().detail;
  EXPECT_EQ(found.first().detail, detail);
  EXPECT_EQ(found.explained(), found.differing);
}

TEST(Explain, AConstantByOneUlp) {
  HandStep step;
  step.constants.gravity_px_per_s2 = 1200.0000000000002;
  expect_one_cause(step, "gravity", CauseKind::constant, "GRAVITY 1200 -> 1200.0000000000002");
  const Explained found = explain_library(step);
  EXPECT_EQ(found.first().from, 1200.0);
  EXPECT_EQ(found.first().to, 1200.0000000000002);
}

TEST(Explain, TwoConstantsAreSeveral) {
  HandStep step;
  step.constants.restitution = 0.55;
  step.constants.air_drag = 0.998;
  expect_one_cause(step, "several", CauseKind::constant, "RESTITUTION 0.6 -> 0.55, AIR_DRAG 0.999 -> 0.998");
}

TEST(Explain, DragBeforeGravity) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s *= 0.999;
    s.vy_px_per_s += 1200.0 * dt_s;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
  };
  expect_one_cause(step, "drag", CauseKind::order, "drag before gravity");
}

TEST(Explain, PositionBeforeVelocity) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
    s.vy_px_per_s += 1200.0 * dt_s;
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s *= 0.999;
  };
  expect_one_cause(step, "position", CauseKind::order, "position before gravity");
}

TEST(Explain, WallsInYBeforeThoseInX) {
  HandStep step;
  step.has_y_walls_first = true;
  expect_one_cause(step, "wall_y", CauseKind::order, "the walls in y before the walls in x");
}

TEST(Explain, FrictionDroppedDoubledAndOnTheOtherSpeed) {
  HandStep dropped;
  dropped.ground = [](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * 0.6;
    if (std::fabs(s.vy_px_per_s) < 5.0) s.vy_px_per_s = 0.0;
  };
  expect_one_cause(dropped, "friction", CauseKind::dropped, "dropped: ground: vx *= GROUND_FRICTION");
  HandStep doubled;
  doubled.ground = [](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * 0.6;
    s.vx_px_per_s *= 0.8;
    s.vx_px_per_s *= 0.8;
    if (std::fabs(s.vy_px_per_s) < 5.0) s.vy_px_per_s = 0.0;
  };
  expect_one_cause(doubled, "friction", CauseKind::doubled, "twice: ground: vx *= GROUND_FRICTION");
  HandStep swapped;
  swapped.ground = [](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * 0.6;
    s.vy_px_per_s *= 0.8;
    if (std::fabs(s.vy_px_per_s) < 5.0) s.vy_px_per_s = 0.0;
  };
  expect_one_cause(swapped, "friction", CauseKind::swapped,
                   "ground: vx *= GROUND_FRICTION -> vy *= GROUND_FRICTION");
}

TEST(Explain, DragDroppedInXOnly) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    s.vy_px_per_s += 1200.0 * dt_s;
    s.vy_px_per_s *= 0.999;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
  };
  expect_one_cause(step, "drag", CauseKind::dropped, "dropped: vx *= AIR_DRAG");
}

TEST(Explain, FusedMultiplyAdds) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    s.vy_px_per_s = std::fma(1200.0, dt_s, s.vy_px_per_s);
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s *= 0.999;
    s.x_px = std::fma(s.vx_px_per_s, dt_s, s.x_px);
    s.y_px = std::fma(s.vy_px_per_s, dt_s, s.y_px);
  };
  expect_one_cause(step, "several", CauseKind::fused,
                   "fused: vy += GRAVITY * dt; fused: x += vx * dt; fused: y += vy * dt");
}

TEST(Explain, RestitutionWithoutMinusAtTheTop) {
  HandStep step;
  step.top = [](State& s) {
    s.y_px = 0.0;
    s.vy_px_per_s = s.vy_px_per_s * 0.6;
  };
  expect_one_cause(step, "restitution", CauseKind::sign, "top: sign changed: vy = -vy * RESTITUTION");
}

TEST(Explain, TwoChangesAtOnceAreClaimedOnlyWhereOneOfThemActs) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s *= 0.999;
    s.vy_px_per_s += 1200.0 * dt_s;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
  };
  step.ground = [](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * 0.6;
    s.vx_px_per_s *= 0.8;
    s.vx_px_per_s *= 0.8;
  };
  const Explained found = explain_library(step);
  for (const CauseGroup& group : found.groups)
    if (group.cause.kind != CauseKind::unknown) {
      EXPECT_EQ(group.cause.detail, "drag before gravity");
    }
  EXPECT_LT(found.explained(), found.differing);
}

TEST(Explain, ANumberInPlaceOfAConstantIsFitted) {
  HandStep step;
  step.top = [](State& s) {
    s.y_px = 0.0;
    s.vy_px_per_s = -s.vy_px_per_s * 0.55;
  };
  expect_one_cause(step, "restitution", CauseKind::constant, "top: RESTITUTION 0.6 -> 0.55");
  HandStep rest;
  rest.ground = [](State& s, const Bounds& bounds) {
    s.y_px = bounds.bottom_px;
    s.vy_px_per_s = -s.vy_px_per_s * 0.6;
    s.vx_px_per_s *= 0.8;
    if (std::fabs(s.vy_px_per_s) < 20.0) s.vy_px_per_s = 0.0;
  };
  const Explained found = explain_library(rest);
  EXPECT_EQ(found.first().operation, "rest_rule");
  EXPECT_EQ(found.explained(), found.differing);
}

TEST(Explain, AnotherLawIsUnknown) {
  HandStep step;
  step.fly = [](State& s, double dt_s) {
    const double vx_before = s.vx_px_per_s, vy_before = s.vy_px_per_s;
    s.vy_px_per_s += 1200.0 * dt_s;
    s.vx_px_per_s *= 0.999;
    s.vy_px_per_s *= 0.999;
    s.x_px += (vx_before + s.vx_px_per_s) / 2.0 * dt_s;
    s.y_px += (vy_before + s.vy_px_per_s) / 2.0 * dt_s;
  };
  const Explained found = explain_library(step);
  EXPECT_EQ(found.explained(), 0u);
}

}  // namespace
}  // namespace hyrax

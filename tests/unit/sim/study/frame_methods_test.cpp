// The methods of a work-precision diagram; SpeedErrorRules hold their orders.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/speed_error/speed_error.h"

namespace hyrax {
namespace {

MethodKind kind_of(const std::string& name) {
  for (const MethodKind& kind : frame_methods(shipped_core()))
    if (kind.name == name) return kind;
  ADD_FAILURE() << "no method " << name;
  return {};
}

Problem problem_named(const std::string& name) {
  for (const Problem& problem : study_problems())
    if (problem.name == name) return problem;
  ADD_FAILURE() << "no problem " << name;
  return {};
}

MethodErrors errors_of(const std::string& method, const Problem& problem, double rate_hz) {
  return measure_errors(shipped_core(), problem, kind_of(method), stage_frames_s(problem, rate_hz), rate_hz);
}

// Methods that find impacts frame by frame converge to the exact impacts.
TEST(FrameMethods, AllThatSolveTheFixedLawsTendToTheSameFling) {
  for (const char* name : {"fling", "corner-fling", "jittered-fling"}) {
    const Problem fling = problem_named(name);
    for (const char* method : {"normalised-drag", "verlet", "rk4", "exact-flight"}) {
      const MethodErrors coarse = errors_of(method, fling, 120.0);
      const MethodErrors fine = errors_of(method, fling, 7680.0);
      EXPECT_LT(fine.position_px, coarse.position_px / 8.0) << method << ", " << name;
      // Each of three impacts is found up to a frame late, which jitter makes half as long again.
      EXPECT_LT(fine.contact_time_s, 3.0 * 1.5 / 7680.0) << method << ", " << name;
    }
    EXPECT_GT(errors_of("paper", fling, 7680.0).position_px, 100.0) << name;
  }
}

TEST(FrameMethods, ImpactsInsideTheFrameKeepAFastSpriteInsideASmallWindow) {
  Problem problem = problem_named("fling");
  problem.start = {1.0, 2.0, 1e6, -1e6};
  problem.stages = {{.duration_s = 5.0, .bounds = {3.0, 0.0}}};
  const MethodErrors errors = errors_of("exact-impacts", problem, 15.0);
  EXPECT_FALSE(errors.is_failed);
  EXPECT_LT(errors.position_px, 1e-6);
}

// What changes nothing, a hitch of one frame's length and the window's own size, cuts the slide into stages.
TEST(FrameMethods, ASlideGoesOnPastWhatLeavesItOnTheGround) {
  Problem slide = problem_named("fling"), cut = slide;
  const Bounds room = slide.stages[0].bounds;
  slide.start = cut.start = {100.0, room.bottom_px, 3000.0, 0.0};
  slide.stages = {{.duration_s = 1.0, .bounds = room}};
  cut.stages = {{.duration_s = 0.25, .bounds = room},
                {.duration_s = 0.25, .bounds = room, .hitch_s = 1.0 / 64.0},
                {.duration_s = 0.5, .bounds = room, .inputs = {Resize{.window = Size{1920, 1080}}}}};
  for (const MethodKind& kind : frame_methods(shipped_core())) {
    const MethodErrors whole = errors_of(kind.name, slide, 64.0), parts = errors_of(kind.name, cut, 64.0);
    EXPECT_NEAR(parts.position_px, whole.position_px, 1e-9) << kind.name;
    EXPECT_NEAR(parts.end_px, whole.end_px, 1e-9) << kind.name;
  }
}

TEST(FrameMethods, AMethodThatLeavesTheNumbersHasFailed) {
  class Lost final : public Method {
   public:
    void start(const State&, const Bounds&, bool) override {}
    bool play(std::span<const double>) override { return true; }
    [[nodiscard]] State motion() const override { return {std::nan(""), 0.0, 0.0, 0.0}; }
  };
  MethodKind kind{.name = "lost", .make = [] { return std::make_unique<Lost>(); }};
  const Problem arc = problem_named("long-arc");
  EXPECT_TRUE(measure_errors(shipped_core(), arc, kind, stage_frames_s(arc, 60.0), 60.0).is_failed);
}

}  // namespace
}  // namespace hyrax

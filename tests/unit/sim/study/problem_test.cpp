// Scenarios as problems that can be played at any rate, and by which laws and constants a core is measured.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "sim/study/methods/problem.h"
#include "sim/study/reference_model.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

Scenario fling() { return fling_at(60.0, 120); }

TEST(ProblemOfScenario, EventsBeginStagesAtTheirTimes) {
  Scenario scenario = fling();
  scenario.events = {{std::int64_t{30}, Fling{{-500.0, -500.0}}},
                     {std::int64_t{60}, Grab{}},
                     {std::int64_t{90}, Release{{700.0, 0.0}}}};
  const Problem problem = problem_of(scenario).problem.value();
  ASSERT_EQ(problem.stages.size(), 4u);
  for (const Stage& stage : problem.stages) EXPECT_NEAR(stage.duration_s, 0.5, 1e-12);
  EXPECT_EQ(std::get<Fling>(problem.stages[1].inputs.front()).velocity.vx_px_per_s, -500.0);
  EXPECT_TRUE(problem.stages[2].is_held);
  EXPECT_FALSE(problem.stages[3].is_held);
}

TEST(ProblemOfScenario, JitterGoesWithTheRate) {
  Scenario scenario = fling();
  scenario.clock.jitter = Jitter{Jitter::Kind::normal, 0.001, 3};
  const Problem problem = problem_of(scenario).problem.value();
  const std::vector<double> frames_s = stage_frames_s(problem, 600.0).front();
  double largest_s = 0.0;
  for (const double frame_s : frames_s) largest_s = std::max(largest_s, std::fabs(frame_s - 1.0 / 600.0));
  EXPECT_GT(largest_s, 0.0001);  // A tenth of what it is at 60 Hz, times three or so.
  EXPECT_LT(largest_s, 0.0006);
  scenario.events = {{std::int64_t{60}, Stop{}}};
  std::size_t frame = 0;
  for (const std::vector<double>& stage : stage_frames_s(problem_of(scenario).problem.value(), 600.0))
    for (const double frame_s : stage)
      EXPECT_NEAR(frame_s, frames_s.at(frame++), 1e-5) << "as without the event";
}

TEST(ProblemOfScenario, AFrameIsMissedAsOftenAtEveryRate) {
  Scenario scenario = fling();
  scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.5, 3};
  const Problem problem = problem_of(scenario).problem.value();
  for (const double rate_hz : {60.0, 600.0}) {
    const std::vector<double> frames_s = stage_frames_s(problem, rate_hz).front();
    const auto missed =
        std::ranges::count_if(frames_s, [&](double frame_s) { return frame_s > 1.5 / rate_hz; });
    EXPECT_NEAR(static_cast<double>(missed) / static_cast<double>(frames_s.size()), 0.5, 0.1) << rate_hz;
  }
}

TEST(ProblemOfScenario, IsCutOnlyAboveItsLimits) {
  Scenario scenario = fling();
  scenario.clock.base = FixedStep{0.5};
  const auto steps = static_cast<std::int64_t>(2.0 * kProblemMax_s);
  for (const std::int64_t more : {0, 1}) {
    scenario.length = steps + more;
    const Problem problem = problem_of(scenario).problem.value();
    EXPECT_EQ(problem.duration_s(), kProblemMax_s + 0.5 * static_cast<double>(more));
    EXPECT_EQ(problem.remark.empty(), more == 0);
  }
  scenario.length = std::int64_t{1};
  for (const double longest_s : {2.0 * kProblemMax_s, std::nextafter(2.0 * kProblemMax_s, HUGE_VAL)}) {
    scenario.clock.base = FixedStep{longest_s};
    EXPECT_EQ(problem_of(scenario).problem.has_value(), longest_s == 2.0 * kProblemMax_s);
  }
  scenario.clock.base = FixedRate{60.0};
  for (const std::int32_t height_px : {1080, 1081}) {
    scenario.sprite = {1920, height_px};
    EXPECT_EQ(problem_of(scenario).problem.has_value(), height_px == 1080) << "it just fits";
  }
}

TEST(ProblemOfScenario, WithoutTimeOrRoomIsRefused) {
  Scenario none = fling(), narrow = fling(), slow = fling();
  none.length = std::int64_t{0};
  narrow.sprite = {4000, 128};
  slow.clock.base = FixedStep{1e6};
  for (const auto& [scenario, why] :
       {std::pair(none, "no time passes in it"),
        {narrow, "its window cannot hold its sprite, so that it has no exact solution"},
        {slow, "a frame of it lasts longer than a study may"}}) {
    EXPECT_FALSE(problem_of(scenario).problem);
    EXPECT_EQ(problem_of(scenario).why_not, why);
  }
}

std::string problems_text(const Model& model) {
  std::string text;
  for (const Problem& problem : study_problems(FixedLaws(model))) {
    const State& start = problem.start;
    text += fmt::format("{}: {:g} {:g} {:g} {:.0f} {:g} s{}{}{}{}\n", problem.name, start.x_px, start.y_px,
                        start.vx_px_per_s, start.vy_px_per_s, problem.duration_s(),
                        problem.is_free_flight ? " free" : "", problem.jitter ? " jittered" : "",
                        problem.remark.empty() ? "" : " ", problem.remark);
  }
  return text;
}

// Without drag there is no terminal speed.
TEST(StudyProblems, AreTheMotionsApproved) {
  std::string text;
  for (const Model& model : {Model(), Model({980.0, 0.9, 0.9995, 0.7, 8.0}),
                             Model({500.0, 1.0, 1.0, 0.8, 5.0}), Model({9.81, 0.3, 0.99, 1.0, 0.01})})
    text += fmt::format("gravity {:g}, restitution {:g}, drag {:g}\n", model.gravity_px_per_s2,
                        model.restitution, model.air_drag) +
            problems_text(model);
  expect_approved("tests/unit/sim/study/approved/problems.txt", text);
}

// Of the exact fling, which takes walls that it meets at one time together.
TEST(StudyProblems, TheCornerIsMetAtBothWallsAtOneTime) {
  for (const Model& model :
       {Model(), Model({500.0, 1.0, 1.0, 0.8, 5.0}), Model({9.81, 0.3, 0.5, 1.0, 0.01})}) {
    const Problem corner = study_problems(FixedLaws(model))[4];
    ExactFling fling{FixedLaws(model)};
    fling.start(corner.start, corner.stages.front().bounds);
    static_cast<void>(fling.at(2.0));
    ASSERT_GE(fling.impacts().size(), 2u);
    EXPECT_NE(fling.impacts()[0].wall, fling.impacts()[1].wall);
    EXPECT_NEAR(fling.impacts()[0].t_s, fling.impacts()[1].t_s, 1e-12);
  }
}

constexpr Constants kOthers{.gravity_px_per_s2 = 900.0,
                            .restitution = 0.7,
                            .air_drag = 0.99,
                            .ground_friction = 0.5,
                            .rest_threshold_px_per_s = 4.0};

TEST(ReferenceModel, HasTheConstantsOfACoreOfItsOwnModelAndThePapersTableOfAnyOther) {
  const Model own = reference_model("mine/1", kOthers, {});
  EXPECT_TRUE(same_bits({own.gravity_px_per_s2, own.restitution, own.air_drag, own.ground_friction,
                         own.rest_threshold_px_per_s},
                        kOthers));
  EXPECT_EQ(own.model_rate_hz, 60.0);
  EXPECT_EQ(reference_model(kPhysicsModel, kOthers, {}).air_drag, 0.999) << "a changed constant is an error";
  EXPECT_EQ(reference_model("mine/1", {}, {}).air_drag, 0.999);
}

TEST(WhyNotMeasurable, NamesTheConstantAndWhatIsAllowed) {
  struct Case {
    double Constants::*constant;
    double value;
    const char* why_not;
  };
  for (const auto& [constant, value, why_not] :
       {Case{&Constants::gravity_px_per_s2, 0.0, ""},
        {&Constants::gravity_px_per_s2, -1.0, "GRAVITY: must be 0 .. 1000000000000 (found -1)"},
        {&Constants::air_drag, 0.5, ""},
        {&Constants::air_drag, 1.0, ""},
        {&Constants::air_drag, 0.499, "AIR_DRAG: must be 0.5 .. 1 (found 0.499)"},
        {&Constants::air_drag, 1.001, "AIR_DRAG: must be 0.5 .. 1 (found 1.001)"},
        {&Constants::restitution, 1.0, ""},
        {&Constants::restitution, 1.1, "RESTITUTION: must be 0 .. 1 (found 1.1)"},
        {&Constants::ground_friction, 0.0, ""},
        {&Constants::ground_friction, -0.5, "GROUND_FRICTION: must be 0 .. 1 (found -0.5)"},
        {&Constants::rest_threshold_px_per_s, 1e12, ""},
        {&Constants::rest_threshold_px_per_s, 2e12,
         "REST_THRESHOLD: must be 0 .. 1000000000000 (found 2000000000000)"}}) {
    Constants constants = kOthers;
    constants.*constant = value;
    EXPECT_EQ(why_not_measurable(constants), why_not);
  }
}

}  // namespace
}  // namespace hyrax

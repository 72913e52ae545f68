// What studies measure, and a core, a method or a reference that turns each verdict.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/speed_error/speed_error.h"
#include "tests/unit/sim/study/clocks.h"

namespace hyrax {
namespace {

TEST(FrameRate, TheGateBreaksByAnotherCoreAndByAMethodThatIsNoSteadier) {
  FrameRateStudy study = study_frame_rate(shipped_core(), {24.0, 144.0}, 30);
  EXPECT_EQ(frame_rate_result(study).verdict.broken, std::vector<std::string>{});
  for (const double rate_hz : {24.0, 144.0}) {
    const auto landing = std::ranges::find_if(study.landings, [&](const Landing& each) {
      return each.method == 0 && each.clock == DisplayClock::jittered && each.rate_hz == rate_hz;
    });
    ASSERT_NE(landing, study.landings.end());
    landing->is_core = false;
  }
  study.shifts[1].settled.count -= 2;
  study.steadier_by_time = {Share{40, 60}, Share{37, 60}, Share{0, 4}};
  EXPECT_EQ(frame_rate_result(study).verdict.broken,
            (std::vector<std::string>{
                "24 Hz, jittered: the method called the paper's step differs from the core",
                "144 Hz, the paper's step: 2 of 31 flings have not settled within 16 s",
                "frames jittered by 2 ms (normal): drag and friction by time spread less in 37 of 60 flings "
                "(49 .. 73 %): they are no more independent of the frame rate than the paper's step",
                "one frame in twenty missed: drag and friction by time spread less in 0 of 4 flings "
                "(0 .. 49 %): they are no more independent of the frame rate than the paper's step"}));
}

// At 60 Hz vy ends in a two-cycle or at the residual speed, at 144 Hz at 0; vx shrinks on and on.
TEST(FrameRate, ASettledSpriteStandsStillAndSomeOfItsSpeedsStillChange) {
  const FrameRateStudy study = study_frame_rate(shipped_core(), {60.0, 144.0}, 30);
  for (const std::size_t rate : {0u, 1u}) {
    const DisplayShift& at = study.shifts[rate];
    EXPECT_EQ(at.settled.count, 31);
    EXPECT_EQ(at.moves_px, 0.0);
    EXPECT_EQ(at.changing[0] + at.changing[1], 0);
    EXPECT_EQ(at.changing[2], 31);
    EXPECT_EQ(at.changing[3] > 0, rate == 0);
    EXPECT_LT(at.changing[3], 31);
  }
}

TEST(FrameRate, PlaysFlingsForAsLongAsTheCoresConstantsAskAndSaysWhereThatIsCut) {
  Constants laws{980.0, 0.9, 0.9995, 0.7, 8.0};
  const FrameRateStudy lively = study_frame_rate(listing_core(laws), {24.0, 240.0}, 20);
  EXPECT_GT(lively.until_s, 25.0);
  EXPECT_FALSE(lively.is_cut);
  for (const DisplayShift& shift : lively.shifts)
    EXPECT_TRUE(shift.settled.count == 21 || shift.clock == DisplayClock::missing);
  laws.restitution = laws.air_drag = 1.0;
  const FrameRateStudy endless = study_frame_rate(listing_core(laws), {24.0, 240.0}, 20);
  EXPECT_TRUE(endless.is_cut);
  EXPECT_LT(endless.shifts[0].settled.count, 21);
  const Verdict verdict = frame_rate_result(endless).verdict;
  EXPECT_NE(std::get<std::string>(verdict.text[4]).find("within 60 s"), std::string::npos);
  EXPECT_NE(std::get<std::string>(verdict.text[4]).find("Some may take longer"), std::string::npos);
  for (const std::string& sentence : verdict.broken)
    EXPECT_EQ(sentence.find("not settled"), std::string::npos) << sentence;
}

TEST(FrameRate, AShiftIsFromTheRateNearestToSixtyHertz) {
  for (const auto& rates_hz : {std::vector{59.0, 60.2, 240.0}, std::vector{60.8, 59.75, 58.8}}) {
    const FrameRateStudy study = study_frame_rate(shipped_core(), rates_hz, 1);
    EXPECT_GT(study.shifts[0].shift_px.high, 0.0);
    EXPECT_EQ(study.shifts[1].shift_px.high, 0.0) << "from itself";
    EXPECT_GT(study.shifts[2].shift_px.high, 0.0);
  }
}

MethodKind method_named(const std::string& name) {
  const std::vector<MethodKind> kinds = frame_methods(shipped_core());
  return *std::ranges::find(kinds, name, &MethodKind::name);
}
Problem studied_problem(const std::string& name) {
  const std::vector<Problem> problems = study_problems(FixedLaws());
  return *std::ranges::find(problems, name, &Problem::name);
}

// Says that it meets walls when the exact fling does, whatever its rows.
class ClaimsExactImpacts : public Method {
 public:
  explicit ClaimsExactImpacts(std::unique_ptr<Method> method) : method_(std::move(method)) {}
  void start(const State& motion, const Bounds& bounds, bool goes_on) override {
    method_->start(motion, bounds, goes_on);
    exact_.start(motion, bounds);
  }
  bool play(std::span<const double> frames_s) override {
    for (const double dt_s : frames_s) time_.play(dt_s);
    static_cast<void>(exact_.at(time_.time_s()));
    return method_->play(frames_s);
  }
  [[nodiscard]] State motion() const override { return method_->motion(); }
  [[nodiscard]] const std::vector<ExactImpact>* impacts() const override { return &exact_.impacts(); }

 private:
  std::unique_ptr<Method> method_;
  ExactFling exact_;
  Timeline time_;
};

// A bounce takes 64 % of the vertical energy: where only one of both has had it, they differ by as much.
TEST(SpeedError, ComparesEnergiesWhereBothHaveMetEachWallEquallyOften) {
  const Problem fling = studied_problem("fling");
  const auto energy_of = [&](const MethodKind& kind) {
    return measure_errors(shipped_core(), fling, kind, stage_frames_s(fling, 60.0), 60.0).energy_rel;
  };
  const MethodKind paper = method_named("paper");
  MethodKind claims = paper;
  claims.make = [&paper] { return std::make_unique<ClaimsExactImpacts>(paper.make()); };
  EXPECT_LT(energy_of(paper), 0.05);
  EXPECT_GT(energy_of(claims), 0.2);
}

TEST(SpeedError, TheScanFindsTheLeastErrorBetweenTheRatesOrAtTheirEnd) {
  const Problem arc = studied_problem("long-arc");
  const auto error_px = [&](double rate_hz) {
    return measure_errors(shipped_core(), arc, method_named("paper"), stage_frames_s(arc, rate_hz), rate_hz)
        .position_px;
  };
  const LeastError paper = least_error(shipped_core(), arc, method_named("paper"), {15.0, 60.0, 960.0});
  EXPECT_LT(paper.position_px, error_px(60.0) - 0.1);
  for (double rate_hz = 15.0; rate_hz < 960.0; rate_hz *= 1.01)
    EXPECT_LT(paper.position_px, error_px(rate_hz) + 0.01);
  EXPECT_NEAR(paper.rate_hz, 56.0, 1.0);
  EXPECT_EQ(least_error(shipped_core(), arc, method_named("normalised-drag"), {15.0, 60.0, 960.0}).rate_hz,
            960.0);
}

TEST(SpeedError, AnOrderWithWallsIsTheMedianOfManyFlings) {
  SpeedErrorOptions options;
  options.rates_hz = {60.0};
  options.order_rates_hz = {60.0, 120.0, 240.0, 480.0, 960.0};
  options.cost.rounds = 1;
  const std::vector<MethodKind> methods = {method_named("exact-flight"), method_named("swept-clamp"),
                                           method_named("paper")};
  const SpeedError study =
      study_speed_error(shipped_core(), {studied_problem("fling")}, methods, options, metered<steady_ns>);
  ASSERT_EQ(study.orders.size(), 2u) << "the paper's step has none";
  for (const auto& [method, order] : {std::pair(std::size_t{0}, 1.0), {1, 2.0}}) {
    EXPECT_EQ(study.orders[method].flings, kOrderFlings);
    EXPECT_NEAR(study.orders[method].order, order, 0.15);
    EXPECT_LT(study.orders[method].least, study.orders[method].order - 0.05);
    EXPECT_GT(study.orders[method].most, study.orders[method].order + 0.05);
  }
}

}  // namespace
}  // namespace hyrax

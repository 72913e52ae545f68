// Every closed form against numbers of 256 bits.
#include "sim/reference/arc_solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sim/reference/flight.h"
#include "sim/reference/phi.h"
#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

constexpr double kGravity = 1200.0;
constexpr double kAirDrag = 0.999;

// The error of displacement and speed, relative to |v| t + g t^2 / 2 and to |v| + g t.
double relative_error(const AxisMotion& motion, const WideMotion& truth, double v, double t) {
  const double path = std::fabs(v) * t + kGravity * t * t / 2;
  const double speed = std::fabs(v) + kGravity * t;
  return std::max(std::fabs((truth.displacement - motion.displacement_px).rounded()) / path,
                  std::fabs((truth.speed - motion.speed_px_per_s).rounded()) / speed);
}

AxisMotion in_y(const State& flight) { return {flight.y_px, flight.vy_px_per_s}; }

// Flies frames of these dt; returns the largest distance of a row from `truth` at its time.
template <class Truth>
double worst_error(const std::vector<double>& frames_s, double v, Truth truth_after,
                   State (ArcSolution::*ours)() const) {
  ArcSolution solution((Model()));
  solution.start({0.0, v}, false);
  double worst = 0.0;
  for (const double dt_s : frames_s) {
    solution.advance(dt_s);
    const WideMotion truth = truth_after(dt_s);
    if (solution.elapsed_s() > 0.0)
      worst = std::max(worst, relative_error(in_y((solution.*ours)()), truth, v, solution.elapsed_s()));
  }
  return worst;
}

// The logarithm takes most of the time of a truth.
const Wide& minus_log_drag() {
  static const Wide value = Wide(0.0) - log(Wide(kAirDrag));
  return value;
}

struct MatchedTruth {
  WideMotion motion;
  WideMotion operator()(double dt_s) {
    motion.fly(kGravity, minus_log_drag(), dt_s);
    return motion;
  }
};

struct DiscreteTruth {
  WideMotion motion;
  WideMotion operator()(double dt_s) {
    motion.speed = (motion.speed + Wide(kGravity) * dt_s) * kAirDrag;
    motion.displacement = motion.displacement + motion.speed * dt_s;
    return motion;
  }
};

std::vector<double> jittered_frames(int count) {
  std::mt19937_64 random(3);
  std::vector<double> frames_s;
  for (int i = 0; i < count; ++i)
    frames_s.push_back(i % 50 == 7 ? 0.0 : std::uniform_real_distribution<>(0.0, 1.0 / 30)(random));
  return frames_s;
}

// Tolerances: the goal is 1e-14; what is measured is a few roundings of 1.1e-16.
constexpr double kTolerance = 1e-15;

// The flow of v' = kappa G - k v, y' = kappa v + eta over one frame, in the textbook form.
struct ExactLawTruth {
  WideMotion motion;
  WideMotion operator()(double dt_s) {
    const Wide a = kAirDrag;
    const Wide& log_drag = minus_log_drag();
    const Wide kappa = a * log_drag / (Wide(1.0) - a);
    const Wide phi1 = (Wide(1.0) - a) / log_drag;
    const Wide gain = Wide(kGravity) * dt_s;
    const Wide eta = a * gain - kappa * kappa * (gain / log_drag) * (Wide(1.0) - phi1);
    const Wide phi2 = (Wide(1.0) - phi1) / log_drag;
    motion.displacement =
        motion.displacement + Wide(dt_s) * (kappa * (phi1 * motion.speed + kappa * gain * phi2) + eta);
    motion.speed = a * motion.speed + kappa * gain * phi1;
    return motion;
  }
};

// Over a hundred seconds, and under jitter, where each frame has its own rate.
TEST(ArcSolution, FollowsEveryLaw) {
  const auto steady = [](int rate_hz) {
    return std::pair(-900.0, std::vector(static_cast<std::size_t>(100 * rate_hz), 1.0 / rate_hz));
  };
  for (const auto& [v, frames_s] :
       {steady(24), steady(60), steady(240), std::pair(700.0, jittered_frames(6000))}) {
    SCOPED_TRACE(frames_s.size());
    EXPECT_LT(worst_error(frames_s, v, DiscreteTruth{{0.0, v}}, &ArcSolution::discrete), kTolerance);
    EXPECT_LT(worst_error(frames_s, v, ExactLawTruth{{0.0, v}}, &ArcSolution::exact_law), kTolerance);
    EXPECT_LT(worst_error(frames_s, v, MatchedTruth{{0.0, v}}, &ArcSolution::matched), kTolerance);
  }
}

// Random arcs up to 100 s, from no drag to the drag of a million frames a second: a dozen roundings.
TEST(ContinuousClosedForm, AgreesWith256BitsOverAHundredSeconds) {
  std::mt19937_64 random(2);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double v = std::uniform_real_distribution<>(-5000.0, 5000.0)(random);
    const double t = 100.0 * std::pow(10.0, std::uniform_real_distribution<>(-4.0, 0.0)(random));
    const double k = std::pow(10.0, std::uniform_real_distribution<>(-15.0, 3.0)(random));
    WideMotion truth{0.0, v};
    truth.fly(kGravity, Wide(k) * t, t);
    worst = std::max(worst, relative_error(fly(v, kGravity, k, t), truth, v, t));
  }
  EXPECT_LT(worst, 2 * kTolerance);
}

// As functions of z = n ln a, and as sums over n frames: nothing but a and a^n is common to both.
TEST(ExactLaw, HasTheCoefficientsOfTheStepInEveryFrame) {
  for (const double air_drag : {0.5, 0.9, 0.999, 1.0 - 1e-4, 1.0 - 1e-5, 1.0 - 1e-9, 1.0}) {
    Model model;
    model.air_drag = air_drag;
    const FramePowers powers(model);
    for (std::size_t n = 1; n <= FramePowers::kFramesMax; ++n) {
      const FramePower<DoubleDouble>&law = powers.wide(n).exact_law, &step = powers.wide(n).discrete;
      EXPECT_LT(std::fabs((law.sum + -step.sum).hi), 1e-21 * step.sum.hi) << air_drag << ", " << n;
      EXPECT_LT(std::fabs((law.sum_of_sums + -step.sum_of_sums).hi), 1e-21 * step.sum_of_sums.hi)
          << air_drag << ", " << n;
    }
  }
}

TEST(ModelFlight, KeepsTheDragRateOf60HzWhereFramesOf60HzFollowOthersOrAreFollowedByThem) {
  for (const double other_s : {0.0, 0.5, 1.0 / 60})
    for (const bool is_first : {false, true}) {
      ArcSolution solution((Model()));
      solution.start({500.0, -900.0}, true);
      if (is_first) solution.advance(other_s);
      for (int i = 0; i < 200; ++i) solution.advance(1.0 / 60);
      if (!is_first) solution.advance(other_s);
      const double k = -std::log(kAirDrag) * 60;
      const double t_s = 200.0 / 60 + other_s;
      EXPECT_NEAR(solution.model().y_px, fly(-900.0, kGravity, k, t_s).displacement_px, 1e-11) << other_s;
      EXPECT_NEAR(solution.model().x_px, fly(500.0, 0.0, k, t_s).displacement_px, 1e-12) << other_s;
    }
}

TEST(ArcSolution, WithoutDragIsNewtonsParabolaAndItsSums) {
  Model model;
  model.air_drag = 1.0;
  ArcSolution solution(model);
  solution.start({500.0, -900.0}, true);
  for (int i = 0; i < 64; ++i) solution.advance(1.0 / 64);
  EXPECT_EQ(solution.matched().y_px, -300.0);
  EXPECT_EQ(solution.model().y_px, -300.0);
  EXPECT_EQ(solution.discrete().y_px, -900.0 + 1200.0 * (64 * 65 / 2) / (64 * 64));
  EXPECT_EQ(solution.exact_law().y_px, solution.discrete().y_px);
  EXPECT_EQ(solution.gravity_energy_px2_per_s2(), -kGravity * kGravity / 64 / 2);
}

double relative_error(double value, const Wide& truth) {
  return std::fabs(((Wide(value) - truth) / truth).rounded());
}
double relative_error(const DoubleDouble& value, const Wide& truth) {
  return std::fabs(((Wide(value.hi) + value.lo - truth) / truth).rounded());
}

// z from -1e-18 to -1e6, evenly in its logarithm.
double random_z(std::mt19937_64& random) {
  return -std::pow(10.0, std::uniform_real_distribution<>(-18.0, 6.0)(random));
}

// Twelve terms and their sums cost an ulp or two, each of at most eight doublings another half.
TEST(Phi, AgreesWith256BitsAtAnyDamping) {
  std::mt19937_64 random(1);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double z = random_z(random);
    const Phi p = phi(z);
    const WideTextbookPhi truth{Wide(z)};
    worst = std::max({worst, relative_error(p.one, truth.one), relative_error(p.two, truth.two)});
  }
  EXPECT_LT(worst, 1e-15);
}

TEST(WidePhi, HasAHundredBits) {
  for (const double z : {-90.0, -3.0, -1.0, -0.5, -1e-3, -1e-9}) {
    const Phi p = wide_phi({z, 0.0});
    const WideTextbookPhi truth{Wide(z)};
    EXPECT_LT(relative_error(p.one, truth.one), 0x1p-100) << z;
    EXPECT_LT(relative_error(p.two, truth.two), 0x1p-100) << z;
  }
}

TEST(WideLog, HasAHundredBits) {
  for (const double a : {0.5, 0.75, 0.999, 0.99996, 1.0 - 0x1p-40})
    EXPECT_LT(relative_error(wide_log(a), log(Wide(a))), 0x1p-99) << a;
}

Wide position_at(const Approach& approach, const Wide& t) {
  WideMotion motion{approach.position_px, approach.speed_px_per_s};
  motion.fly(approach.acceleration_px_per_s2, Wide(approach.drag_rate_per_s) * t, t);
  return motion.displacement;
}

// The root between two times, inside at the first and outside at the second, by halving.
Wide true_time(const Approach& approach, Wide low, Wide high) {
  for (int i = 0; i < 80; ++i) {
    const Wide middle = (low + high) / 2.0;
    (position_at(approach, middle) < Wide(0.0) ? low : high) = middle;
  }
  return low;
}

struct Draw {
  explicit Draw(std::uint64_t seed) : random(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
  std::mt19937_64 random;
};

// A fall from below 1,000 px above the floor, thrown up or down; drag of 1 .. 1000 Hz or none.
Approach random_fall(Draw& draw) {
  return {-draw(0.1, 1000.0), draw(-2000.0, 2000.0), kGravity,
          draw(0.0, 1.0) < 0.1 ? 0.0 : std::pow(10.0, draw(-3.0, 0.0))};
}

// The goal is 1e-12; the closed form's rounding leaves a few units of 1.1e-16.
TEST(TimeOfImpact, OfAFallAgreesWith256Bits) {
  Draw draw(5);
  for (int i = 0; i < 300; ++i) {
    const Approach fall = random_fall(draw);
    const Wide truth = true_time(fall, Wide(std::max(0.0, -fall.speed_px_per_s) / kGravity / 2.0), 100.0);
    ASSERT_LT(std::fabs(((truth - time_of_impact(fall, 100.0)->t_s) / truth).rounded()), 1e-14) << i;
  }
}

TEST(TimeOfImpact, IsNoneForAWallThatIsNotMetInTheTimeGiven) {
  const Approach fall{-100.0, 0.0, kGravity, 0.06};
  const double t_s = time_of_impact(fall, 10.0)->t_s;
  EXPECT_TRUE(time_of_impact(fall, t_s * (1 + 1e-12)));
  EXPECT_FALSE(time_of_impact(fall, t_s * (1 - 1e-12)));
  // 0.6 px above at the turning point, inside before and after; below it.
  EXPECT_TRUE(time_of_impact({-149.4, 600.0, -kGravity, 0.0}, 1.0));
  EXPECT_FALSE(time_of_impact({-150.1, 600.0, -kGravity, 0.0}, 10.0));
  EXPECT_FALSE(time_of_impact({-0.0, -300.0, 0.0, 0.06}, 10.0)) << "it is left";
  const Impact on_the_wall = time_of_impact({0.0, 0.0, kGravity, 0.06}, 1.0).value();
  EXPECT_EQ(on_the_wall.t_s, 0.0);
  EXPECT_EQ(on_the_wall.speed_px_per_s, 0.0);
}

TEST(TimeOfImpact, OfASpeedTooSmallToDivideIsThatOfRest) {
  const double at_rest_s = time_of_impact({-100.0, 0.0, kGravity, 0.06}, 10.0)->t_s;
  EXPECT_EQ(time_of_impact({-100.0, -2.5e-323, kGravity, 0.06}, 10.0)->t_s, at_rest_s);
}

TEST(TimeOfImpact, IsFoundUnderTheDragOfABillionFramesASecond) {
  // Terminal speed g / k = 1.2e-3 px/s is reached at once: 1e-3 px take 0.83 s.
  const auto impact = time_of_impact({-1e-3, 0.0, kGravity, 1e6}, 10.0);
  EXPECT_NEAR(impact.value().t_s, 1e-3 / 1.2e-3, 1e-5);
}

}  // namespace
}  // namespace hyrax

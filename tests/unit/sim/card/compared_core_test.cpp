#include "sim/card/compared_core.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <stdexcept>

#include "sim/card/core_defect.h"
#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

using Step = void (*)(double dt_s);

volatile std::int64_t* updates = nullptr;  // Counted as a core's library does.

void do_nothing(double) {}
void throw_in_a_long_frame(double dt_s) {
  *updates = *updates + 1;
  if (dt_s == 0.25) throw std::runtime_error("");
}
void round_upward(double) { std::fesetround(FE_UPWARD); }
void round_inexactly(double) { std::feraiseexcept(FE_INEXACT | FE_UNDERFLOW); }

// Whose step does something else, and which names no constants.
template <Step kStep>
struct Doing : private physics {
  using physics::physics, physics::x, physics::y, physics::vx, physics::vy, physics::setPos,
      physics::setVelocity, physics::resetVelocity;
  void update(double dt_s, int, int, int, int) { kStep(dt_s); }
};

template <Step kStep>
std::string refusal(const auto& play) {
  PlayWatch watch{};
  updates = &watch.updates;
  const LibraryCore library{.counted = core_of<Doing<kStep>>(kPhysicsModel, {}),
                            .timed = {},
                            .lacking = "GRAVITY",
                            .defect = nullptr};
  EXPECT_FALSE(library.counted.constants);
  const ComparedCore compared = compared_core(1, library, {.why_incomplete = "not traced"}, watch);
  EXPECT_EQ(compared.core.constants->gravity_px_per_s2, 1200.0);
  try {
    play(compared.at("a fling"));
  } catch (const CoreRefused& refusal) {
    EXPECT_EQ(refusal.core, 1);
    EXPECT_EQ(watch.core, 1);
    return refusal.what();
  }
  return "";
}

const auto play_steps = [](const Core& core) { static_cast<void>(core.steps({}, 0.25, {}, 100)); };

TEST(ComparedCore, IsRefusedIfItThrowsWhereverItIsCalled) {
  const auto play_parts = [](const Core& core) {
    std::vector frames_s(50, 0.125);
    frames_s[21] = 0.5;
    static_cast<void>(core.played({}, frames_s, {}, 2));
  };
  const auto play_scenario = [](const Core& core) {
    static_cast<void>(
        replay(core, fling_at(60.0, 100, {{std::int64_t{40}, Stop{}}, {std::int64_t{42}, Hitch{0.25}}})));
  };
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_steps), "throws an exception in a fling, step 1");
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_parts), "throws an exception in a fling, step 43");
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_scenario), "throws an exception in a fling, step 43");
}

TEST(ComparedCore, IsRefusedIfItChangesTheRounding) {
  EXPECT_EQ(refusal<do_nothing>(play_steps), "");
  const std::string reason = refusal<round_upward>(play_steps);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(reason,
            "changes how the processor computes (rounding mode, subnormals or trapped exceptions): found "
            "after a fling");
}

// Exceptions that have occurred change nothing.
TEST(ComparedCore, MayHaveInexactResults) { EXPECT_EQ(refusal<round_inexactly>(play_steps), ""); }

TEST(PlayWatch, NamesTheStepThatWasBegun) {
  PlayWatch watch{};
  watch.set_place("scenario a.json");
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.begin_call(40, 5);
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.updates = 2;
  EXPECT_EQ(watch.where(), "scenario a.json, step 42");
  watch.updates = 6;  // Not only those of the run.
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.set_place(std::string(500, 'a'));
  EXPECT_EQ(watch.where(), std::string(watch.place.size() - 1, 'a'));
}

// A ball without walls, from which each defect differs in one place.
class Ball {
 public:
  Ball() = default;
  Ball(double x, double y, double vx, double vy) : x_(x), y_(y), vx_(vx), vy_(vy) {}
  void update(double dt, int, int, int, int) {
    x_ += vx_ * dt;
    y_ += vy_ * dt;
  }
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double vx() const { return vx_; }
  [[nodiscard]] double vy() const { return vy_; }
  void setPos(double x, double y) { x_ = x, y_ = y; }
  void setVelocity(double vx, double vy) { vx_ = vx, vy_ = vy; }
  void resetVelocity() { vx_ = vy_ = 0.0; }

 protected:
  double x_ = 0.0, y_ = 0.0, vx_ = 0.0, vy_ = 0.0;
};

struct CountsCalls : Ball {
  using Ball::Ball;
  void update(double dt, int w, int h, int sw, int sh) {
    static int calls = 0;
    if (++calls % 4096 == 0) vx_ += 1.0;
    Ball::update(dt, w, h, sw, sh);
  }
};

struct SharesItsSpeed : Ball {
  SharesItsSpeed() = default;
  SharesItsSpeed(double x, double y, double vx, double vy) : Ball(x, y, vx, vy) { speed = vx; }
  void update(double dt, int w, int h, int sw, int sh) {
    vx_ = speed *= 0.999;
    Ball::update(dt, w, h, sw, sh);
  }
  static inline double speed = 0.0;
};

struct GetterMoves : Ball {
  using Ball::Ball;
  [[nodiscard]] double vy() const {
    const_cast<GetterMoves*>(this)->vy_ +=
        1e-9;  // NOLINT(cppcoreguidelines-pro-type-const-cast): the defect.
    return Ball::vy();
  }
};

struct PositionScalesSpeed : Ball {
  using Ball::Ball;
  void setPos(double x, double y) {
    Ball::setPos(x, y);
    vx_ *= 0.5;
  }
};

struct CountsSteps : Ball {
  using Ball::Ball;
  void update(double dt, int w, int h, int sw, int sh) {
    if (++steps_ == 1000) vx_ = -vx_;
    Ball::update(dt, w, h, sw, sh);
  }
  int steps_ = 0;
};

struct HasRoom : Ball {
  using Ball::Ball;
  double unused_ = 0.0;
};

template <class Core>
std::string defect_of() {
  return DefectSearch<Core>().search();
}

struct HasTwoConstants : Ball {
  static constexpr double AIR_DRAG = 0.5, REST_THRESHOLD = 1.0;
};

TEST(LackingConstants, AreThoseThatAClassDoesNotName) {
  EXPECT_EQ(lacking_constants<Ball>(), "GRAVITY, RESTITUTION, AIR_DRAG, GROUND_FRICTION, REST_THRESHOLD");
  EXPECT_EQ(lacking_constants<HasTwoConstants>(), "GRAVITY, RESTITUTION, GROUND_FRICTION");
  EXPECT_EQ(lacking_constants<physics>(), "");
}

TEST(CoreDefect, IsNoneWhereFourNumbersAreTheState) { EXPECT_EQ(defect_of<Ball>(), ""); }

TEST(CoreDefect, NamesEachKindAndTheStepThatShowsIt) {
  EXPECT_EQ(defect_of<CountsCalls>(), "does not repeat: a fling played twice differs from step 692");
  EXPECT_EQ(defect_of<SharesItsSpeed>(),
            "shares state between bodies: a fling differs if another body moves too from step 2");
  EXPECT_EQ(
      defect_of<GetterMoves>(),
      "is changed by its getters: a fling differs if x(), y(), vx() and vy() are called between steps from "
      "step 1");
  EXPECT_EQ(defect_of<PositionScalesSpeed>(),
            "depends on the order of its setters: setPos before setVelocity or after it differs from step 1");
  EXPECT_EQ(
      defect_of<CountsSteps>(),
      "keeps state between calls beyond x, y, vx and vy: a fling differs if its body is made again from "
      "these four numbers from step 1000");
  EXPECT_EQ(
      defect_of<HasRoom>(),
      "can keep state between calls beyond x, y, vx and vy: an object has 40 bytes, four doubles have 32");
}

}  // namespace
}  // namespace hyrax

#include "sim/card/core_defect.h"

#include <gtest/gtest.h>

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

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

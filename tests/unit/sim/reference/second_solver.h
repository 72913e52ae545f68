// The exact fling a second time: by another algorithm, in 256 bits, without code of sim/.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/unit/sim/reference/wide.h"

namespace hyrax {

/// The constants of the laws, at 60 Hz.
struct SecondLaws {
  double gravity = 1200.0;
  double restitution = 0.6;
  double drag = 0.999;
  double friction = 0.8;
  double threshold = 5.0;
};

/// It asks one thing only: whether the sprite is outside its box after some time. Until its apex, and from
/// there on, what is outside stays outside; so the time at which it leaves is found by halving, whatever wall
/// it leaves through, and every wall that it then is at turns it.
class SecondSolver {
 public:
  struct Motion {
    Wide x, y, vx, vy;
  };

  SecondSolver(const SecondLaws& laws, double right, double bottom, double until)
      : laws_(laws), right_(right), bottom_(bottom), until_(until), drag_(log(Wide(laws.drag)) * -60.0) {}

  void start(const Motion& from) {
    from_ = from;
    find_next();
  }
  /// REQUIRES: times that grow, up to `until`.
  [[nodiscard]] Motion at(double t) {
    while (next_ && !(Wide(t) < begin_ + *next_)) {
      from_ = after(*next_);
      begin_ = begin_ + *next_;
      turn_at_walls();
      find_next();
    }
    return after(Wide(t) - begin_);
  }
  [[nodiscard]] int impacts() const { return impacts_; }

 private:
  // v' = g - k v in the textbook form; of 256 bits it loses half at most.
  [[nodiscard]] Motion after(const Wide& t) const {
    const Wide rate = slides_ ? drag_ + log(Wide(laws_.friction)) * -60.0 : drag_;
    const Wide gravity = slides_ ? 0.0 : laws_.gravity;
    if (rate.rounded() == 0.0)
      return {from_.x + from_.vx * t, from_.y + (from_.vy + gravity * t * 0.5) * t, from_.vx,
              from_.vy + gravity * t};
    const Wide lost = (Wide(1.0) - exp(Wide(0.0) - rate * t)) / rate;
    return {from_.x + from_.vx * lost, from_.y + from_.vy * lost + gravity * (t - lost) / rate,
            from_.vx - rate * from_.vx * lost, from_.vy + (gravity - rate * from_.vy) * lost};
  }
  [[nodiscard]] bool is_outside(const Motion& at) const {
    return at.x < 0.0 || Wide(right_) < at.x || at.y < 0.0 || Wide(bottom_) < at.y;
  }
  [[nodiscard]] static int sign(const Wide& value) { return value < 0.0 ? -1 : Wide(0.0) < value; }

  // The last time before which it never holds. REQUIRES: it holds at high, and from some time on.
  [[nodiscard]] static Wide last_before(Wide low, Wide high, const auto& holds) {
    constexpr int kHalvings = 140;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const Wide middle = (low + high) * 0.5;
      (holds(middle) ? high : low) = middle;
    }
    return low;
  }

  void find_next() {
    const auto outside = [this](const Wide& t) { return is_outside(after(t)); };
    const auto falls = [this](const Wide& t) { return Wide(0.0) < after(t).vy; };
    const Wide end = Wide(until_) - begin_;
    next_.reset();
    if (wall_met(from_.x, from_.vx, right_) != 0 || (!slides_ && wall_met(from_.y, from_.vy, bottom_) != 0)) {
      next_ = 0.0;
      return;
    }
    Wide apex = 0.0;
    if (from_.vy < 0.0) apex = falls(end) ? last_before(0.0, end, falls) : end;
    if (outside(apex))
      next_ = last_before(0.0, apex, outside);
    else if (outside(end))
      next_ = last_before(apex, end, outside);
  }

  // -1 and 1: the near and the far one, where it is at a wall and goes on outwards, or falls.
  [[nodiscard]] int wall_met(const Wide& place, const Wide& speed, double far) const {
    const Wide close = 1e-25 * (1.0 + far);
    if (place < close && speed < 0.0) return -1;
    const bool is_bottom = &place == &from_.y;
    return Wide(far) - close < place && (Wide(0.0) < speed || (is_bottom && sign(speed) == 0)) ? 1 : 0;
  }

  void turn(Wide& place, Wide& speed, double wall) {
    place = wall;
    speed = speed * Wide(-laws_.restitution);
    if (std::fabs(speed.rounded()) < 2.3e-308) speed = 0.0;
    ++impacts_;
  }
  void turn_at_walls() {
    if (const int wall = wall_met(from_.x, from_.vx, right_); wall != 0)
      turn(from_.x, from_.vx, wall < 0 ? 0.0 : right_);
    const int wall = slides_ ? 0 : wall_met(from_.y, from_.vy, bottom_);
    if (wall == 0) return;
    turn(from_.y, from_.vy, wall < 0 ? 0.0 : bottom_);
    if (wall < 0) return;
    from_.vx = from_.vx * Wide(laws_.friction);
    slides_ = std::fabs(from_.vy.rounded()) < laws_.threshold;
    if (slides_) from_.vy = 0.0;
  }

  SecondLaws laws_;
  double right_, bottom_, until_;
  Wide drag_;
  Motion from_;
  Wide begin_;
  std::optional<Wide> next_;
  bool slides_ = false;
  int impacts_ = 0;
};

}  // namespace hyrax

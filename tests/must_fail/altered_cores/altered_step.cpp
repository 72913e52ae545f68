// The listing's step, its operations taken from the altered core in use.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "tests/must_fail/altered_cores/altered_core.h"

namespace hyrax {
namespace {

// What a wall acts on: its axis, and the speed along it.
struct Axis {
  double& position;
  double& speed;
  double& along;
};

void meet(std::string_view operations, const Axis& axis, double bound, double outwards, double dt) {
  const AlteredStep& step = altered_step();
  auto& [p, v, w] = axis;
  const auto is_slow = [&step](double speed) { return std::fabs(speed) < step.rest_threshold; };
  for (const char operation : operations) switch (operation) {
      case 'c':
        p = bound;
        break;
      case 'm':
        p = 2.0 * bound - p;
        break;
      case 't':
        v = -v * step.restitution;
        break;
      case 'i':
        v = -v;
        break;
      case 'k':
        v = v * step.restitution;
        break;
      case 's':
        v = 0.0;
        break;
      case 'h':
        v = -v * 0.5;
        break;
      case 'o':
        v = v * outwards > 0.0 ? -v * step.restitution : v;
        break;
      case 'f':
        w *= step.ground_friction;
        break;
      case 'F':
        v *= step.ground_friction;
        break;
      case 'p':
        w *= std::pow(step.ground_friction, 60.0 * dt);
        break;
      case 'r':
        v = is_slow(v) ? 0.0 : v;
        break;
      case 'e':
        v = std::fabs(v) <= step.rest_threshold ? 0.0 : v;
        break;
      case 'S':
        v = v < step.rest_threshold ? 0.0 : v;
        break;
      case 'l':
        v = std::fabs(v) > step.rest_threshold ? 0.0 : v;
        break;
      case 'q':
        w = is_slow(v) ? 0.0 : w;
        break;
    }
}

bool claims(Claim claim, double position, double bound, bool is_low_wall) {
  switch (claim) {
    case Claim::beyond_bound:
      return is_low_wall ? position < bound : position > bound;
    case Claim::on_bound_too:
      return is_low_wall ? position <= bound : position >= bound;
    case Claim::before_bound:
      return is_low_wall ? position > bound : position < bound;
  }
  return false;
}

}  // namespace

void fly(AlteredBody& body, double dt) {
  const AlteredStep& step = altered_step();
  auto& [x, y, vx, vy, last_dt] = body;
  const double vx_before = vx, vy_before = vy;
  last_dt = dt;
  for (const char operation : step.fly) switch (operation) {
      case 'g':
        vy += step.gravity * dt;
        break;
      case 'u':
        vy -= step.gravity * dt;
        break;
      case 'G':
        vx += step.gravity * dt;
        break;
      case 'X':
        vx *= step.air_drag;
        break;
      case 'Y':
        vy *= step.air_drag;
        break;
      case 'd':
        if (dt > 0.0) vx *= step.air_drag, vy *= step.air_drag;
        break;
      case 'D':
        vx *= std::pow(step.air_drag, 60.0 * dt);
        vy *= std::pow(step.air_drag, 60.0 * dt);
        break;
      case 'E':
        vx *= 1.0 - 60.0 * dt;
        vy *= 1.0 - 60.0 * dt;
        break;
      case 'x':
        x += vx * dt;
        break;
      case 'y':
        y += vy * dt;
        break;
      case 'l':
        vx = std::clamp(vx, -1500.0, 1500.0);
        break;
      case '<':
        x -= vx * dt;
        break;
      case '^':
        y -= vy * dt;
        break;
      case 'a':
        x += vy * dt;
        break;
      case 'b':
        y += vx * dt;
        break;
      case 'v':
        x += (vx_before + vx) / 2.0 * dt;
        y += (vy_before + vy) / 2.0 * dt;
        break;
      case 's':
        y += vy * dt + vx * 1e-9;
        break;
    }
}

void collide(AlteredBody& body, int screen_width, int screen_height, int sprite_width, int sprite_height) {
  const AlteredStep& step = altered_step();
  double right_bound = static_cast<double>(screen_width - step.sprite_sides * sprite_width);
  double bottom_bound = static_cast<double>(screen_height - step.sprite_sides * sprite_height);
  if (step.turns_bounds) std::swap(right_bound, bottom_bound);
  const Axis in_x{body.x, body.vx, body.vy}, in_y{body.y, body.vy, body.vx};
  const auto meets = [&](std::string_view operations, Claim claim, const Axis& axis, double bound,
                         double outwards) {
    if (!claims(claim, axis.position, bound, outwards < 0.0)) return false;
    meet(operations, axis, bound, outwards, body.dt);
    return true;
  };
  const auto left = [&] { return meets(step.left, step.left_claims, in_x, 0.0, -1.0); };
  const auto right = [&] { return meets(step.right, step.right_claims, in_x, right_bound, 1.0); };
  const auto top = [&] { return meets(step.top, step.top_claims, in_y, 0.0, -1.0); };
  const auto ground = [&] { return meets(step.ground, step.ground_claims, in_y, bottom_bound, 1.0); };
  for (const char wall : step.collide) switch (wall) {
      case 'x':
        static_cast<void>(left() || right());
        break;
      case 'y':
        static_cast<void>(top() || ground());
        break;
      case 'Y':
        static_cast<void>(ground() || top());
        break;
      case 'L':
        left();
        break;
      case 'R':
        right();
        break;
      case 'T':
        top();
        break;
      case 'B':
        ground();
        break;
    }
}

// Prints how many updates the program made, if HYRAX_COUNT_UPDATES is set.
class UpdateCount {
 public:
  ~UpdateCount() {
    if (std::getenv("HYRAX_COUNT_UPDATES") != nullptr) std::fprintf(stderr, "updates: %ld\n", count_.load());
  }
  void add() { ++count_; }

 private:
  std::atomic<long> count_ = 0;
};

void update(AlteredBody& body, double dt, int screen_width, int screen_height, int sprite_width,
            int sprite_height) {
  static UpdateCount count;
  count.add();
  static std::atomic<long> steps = 0;
  for (const char half : altered_step().update) switch (half) {
      case 'F':
        fly(body, dt);
        break;
      case 'C':
        collide(body, screen_width, screen_height, sprite_width, sprite_height);
        break;
      case 'n':
        body.x = std::nextafter(body.x, 1e300);
        break;
      case 'h':
        if (++steps % 1009 == 0) body.vx *= 0.5;
        break;
    }
}

void set(double& x, double& y, std::string_view operations, double to_x, double to_y) {
  for (const char operation : operations) switch (operation) {
      case 'x':
        x = to_x;
        break;
      case 'y':
        y = to_y;
        break;
      case 'w':
        x = to_y, y = to_x;
        break;
      case '+':
        x += to_x, y += to_y;
        break;
      case 'z':
        x = y = 0.0;
        break;
    }
}

}  // namespace hyrax

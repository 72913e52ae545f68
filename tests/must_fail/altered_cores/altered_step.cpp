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

void meet(std::string_view operations, const Axis& axis, double bound, double outwards) {
  const AlteredStep& step = altered_step();
  auto& [p, v, w] = axis;
  for (const char operation : operations) {
    const bool is_slow = std::fabs(v) < step.rest_threshold;
    if (operation == 'c') p = bound;
    if (operation == 'm') p = 2.0 * bound - p;
    if (operation == 't') v = -v * step.restitution;
    if (operation == 'k') v = v * step.restitution;
    if (operation == 's') v = 0.0;
    if (operation == 'h') v = -v * 0.5;
    if (operation == 'o') v = v * outwards > 0.0 ? -v * step.restitution : v;
    if (operation == 'f') w *= step.ground_friction;
    if (operation == 'F') v *= step.ground_friction;
    if (operation == 'r') v = is_slow ? 0.0 : v;
    if (operation == 'e') v = std::fabs(v) <= step.rest_threshold ? 0.0 : v;
    if (operation == 'S') v = v < step.rest_threshold ? 0.0 : v;
    if (operation == 'q') w = is_slow ? 0.0 : w;
  }
}

bool claims(Claim claim, double beyond_bound_px) {
  if (claim == Claim::before_bound) return beyond_bound_px < 0.0;
  return beyond_bound_px > 0.0 || (claim == Claim::on_bound_too && beyond_bound_px == 0.0);
}

void fly(AlteredBody& body, double dt) {
  const AlteredStep& step = altered_step();
  auto& [x, y, vx, vy] = body;
  const auto lose = [&body](double factor) { body.vx *= factor, body.vy *= factor; };
  for (const char operation : step.fly) {
    if (operation == 'g') vy += step.gravity * dt;
    if (operation == 'G') vx += step.gravity * dt;
    if (operation == 'X') vx *= step.air_drag;
    if (operation == 'Y') vy *= step.air_drag;
    if (operation == 'd' && dt > 0.0) lose(step.air_drag);
    if (operation == 'D') lose(std::pow(step.air_drag, 60.0 * dt));
    if (operation == 'E') lose(1.0 - 60.0 * dt);
    if (operation == 'x') x += vx * dt;
    if (operation == 'y') y += vy * dt;
    if (operation == '<') x -= vx * dt;
    if (operation == 'a') x += vy * dt;
    if (operation == 'l') vx = std::clamp(vx, -1500.0, 1500.0);
    if (operation == 's') y += vy * dt + vx * 1e-9;
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
    if (!claims(claim, outwards * (axis.position - bound))) return false;
    meet(operations, axis, bound, outwards);
    return true;
  };
  const auto left = [&] { return meets(step.left, step.left_claims, in_x, 0.0, -1.0); };
  const auto right = [&] { return meets(step.right, Claim::beyond_bound, in_x, right_bound, 1.0); };
  const auto top = [&] { return meets(step.top, Claim::beyond_bound, in_y, 0.0, -1.0); };
  const auto ground = [&] { return meets(step.ground, step.ground_claims, in_y, bottom_bound, 1.0); };
  for (const char wall : step.collide) {
    if (wall == 'x') static_cast<void>(left() || right());
    if (wall == 'y') static_cast<void>(top() || ground());
    if (wall == 'Y') static_cast<void>(ground() || top());
    if (wall == 'L') left();
    if (wall == 'R') right();
    if (wall == 'T') top();
    if (wall == 'B') ground();
  }
}

// How many updates the program made, which it prints at its end if HYRAX_COUNT_UPDATES is set.
struct UpdateCount {
  std::atomic<long> made = 0;
  ~UpdateCount() {
    if (std::getenv("HYRAX_COUNT_UPDATES") != nullptr) std::fprintf(stderr, "updates: %ld\n", made.load());
  }
};

}  // namespace

void update(AlteredBody& body, double dt, int screen_width, int screen_height, int sprite_width,
            int sprite_height) {
  static UpdateCount count;
  const long number = ++count.made;
  for (const char half : altered_step().update) {
    if (half == 'F') fly(body, dt);
    if (half == 'C') collide(body, screen_width, screen_height, sprite_width, sprite_height);
    if (half == 'n') body.x = std::nextafter(body.x, 1e300);
    if (half == 'h' && number % 1009 == 0) body.vx *= 0.5;
  }
}

void set(double& x, double& y, std::string_view operations, double to_x, double to_y) {
  for (const char operation : operations) {
    if (operation == 'x') x = to_x;
    if (operation == 'y') y = to_y;
    if (operation == 'w') x = to_y, y = to_x;
    if (operation == '+') x += to_x, y += to_y;
    if (operation == 'z') x = y = 0.0;
  }
}

}  // namespace hyrax

#include "sim/reference/flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/reference/largest.h"

namespace hyrax {
namespace {

// A bracket of doubles is halved to nothing in less than 2,100 turns; Halley's steps take four.
constexpr int kTurnsMax = 2200;

AxisMotion motion(const Approach& approach, double t_s) {
  AxisMotion now =
      fly(approach.speed_px_per_s, approach.acceleration_px_per_s2, approach.drag_rate_per_s, t_s);
  now.displacement_px += approach.position_px;
  return now;
}

// Where v' = a - k v has turned the speed to 0: t = ln(1 - k v / a) / k. REQUIRES: v and a have
// opposite signs; v / a may be too small for a double.
double turning_time_s(const Approach& approach) {
  const double v = approach.speed_px_per_s;
  const double a = approach.acceleration_px_per_s2;
  assert((v < 0.0 && a > 0.0) || (v > 0.0 && a < 0.0));
  const double undamped_s = -v / a;
  const double damping = approach.drag_rate_per_s * undamped_s;
  return damping > 0.0 ? undamped_s * (std::log1p(damping) / damping) : undamped_s;
}

// Root of p + v t + a t^2 / 2 on the way out: the flight without drag.
double ballistic_guess_s(const Approach& approach) {
  const double p = approach.position_px;
  const double v = approach.speed_px_per_s;
  const double a = approach.acceleration_px_per_s2;
  const double root = std::sqrt(std::max(0.0, v * v - 2.0 * a * p));
  return v > 0.0 ? -2.0 * p / (v + root) : (root - v) / a;
}

// Halley's step on position(t) = 0; speed and acceleration are its derivatives.
double halley_step_s(const Approach& approach, const AxisMotion& at) {
  const double slope = at.speed_px_per_s;
  const double bend = approach.acceleration_px_per_s2 - approach.drag_rate_per_s * slope;
  return at.displacement_px * slope / (slope * slope - 0.5 * at.displacement_px * bend);
}

// REQUIRES: inside at low_s, outside at high_s, and outward speed in between.
double root_between(const Approach& approach, double low_s, double high_s) {
  double t_s = ballistic_guess_s(approach);
  for (int turn = 0; turn < kTurnsMax; ++turn) {
    if (!(t_s > low_s && t_s < high_s)) t_s = low_s + 0.5 * (high_s - low_s);
    if (t_s <= low_s || t_s >= high_s) break;  // No double lies in between.
    const AxisMotion at = motion(approach, t_s);
    if (at.displacement_px == 0.0) break;
    (at.displacement_px < 0.0 ? low_s : high_s) = t_s;
    const double next_s = t_s - halley_step_s(approach, at);
    if (std::fabs(next_s - t_s) <= std::numeric_limits<double>::epsilon() * t_s) {
      t_s = next_s;
      break;
    }
    t_s = next_s;
  }
  return t_s;
}

}  // namespace

std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s) {
  const double v = approach.speed_px_per_s;
  const double a = approach.acceleration_px_per_s2;
  double low_s = 0.0;
  double high_s = t_max_s;
  if (v < 0.0) {
    if (!(a > 0.0)) return std::nullopt;  // Moves inwards for good.
    low_s = std::min(turning_time_s(approach), t_max_s);
  } else if (v > 0.0 && a < 0.0) {
    high_s = std::min(turning_time_s(approach), t_max_s);
  }
  if (motion(approach, low_s).displacement_px > 0.0 || !(motion(approach, high_s).displacement_px > 0.0))
    return std::nullopt;
  const double t_s =
      low_s == 0.0 && approach.position_px == 0.0 ? 0.0 : root_between(approach, low_s, high_s);
  return Impact{t_s, larger(0.0, motion(approach, t_s).speed_px_per_s), approach.drag_rate_per_s};
}

}  // namespace hyrax

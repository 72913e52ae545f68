// Sections 1, 2.1, 2.2 and 2.3: gravity, drag, position.
#include <algorithm>

#include "sim/core/core.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

Finding axes(const Core& core) {
  const State fallen = core.flight({0.0, 0.0, 1.0, 0.0}, kSixtieth_s);
  return {fallen.y_px, holds_if(fallen.x_px > 0.0 && fallen.y_px > 0.0)};
}

// A step gives a (v + G dt) if drag follows gravity, so dividing by a leaves v + G dt; with drag first the
// result would be G / a.
Finding gravity(const Core& core) {
  const double constant = core.constants->gravity_px_per_s2;
  const double drag = core.flight({0.0, 0.0, 1.0, 0.0}, kSixtieth_s).vx_px_per_s;
  Extremes gained;
  for (const double vy_px_per_s : {-900.0, 0.0, 900.0})
    for (const double dt_s : {1e-3, kSixtieth_s, 0.1}) {
      const State after = core.flight({0.0, 0.0, 0.0, vy_px_per_s}, dt_s);
      gained.include((after.vy_px_per_s / drag - vy_px_per_s) / dt_s);
    }
  return {gained.least,
          holds_if(gained.least > 0.0 && is_close(gained.least, constant, 1e-6) &&
                   is_close(gained.most, constant, 1e-6)),
          is_close(gained.least, gained.most, 1e-6) ? "" : "up to " + digits(gained.most) + " px/s²"};
}

// Gravity adds the same to every speed, so a difference of speeds changes by drag alone.
Finding drag_factor(const Core& core) {
  const State fast = core.flight({0.0, 0.0, 1000.0, 1000.0}, kSixtieth_s);
  const State slow = core.flight({0.0, 0.0, 500.0, 500.0}, kSixtieth_s);
  const double x_factor = (fast.vx_px_per_s - slow.vx_px_per_s) / 500.0;
  const double y_factor = (fast.vy_px_per_s - slow.vy_px_per_s) / 500.0;
  const bool is_same = is_close(x_factor, y_factor, 1e-9);
  return {x_factor, holds_if(is_same && x_factor < 1.0), is_same ? "" : "in vy it is " + digits(y_factor)};
}

// Rate of decay over a second of flight.
double decay_per_s(const Core& core, double speed_px_per_s, double rate_hz) {
  const State body = state_after(core, {1e9, 1e9, speed_px_per_s, 0.0}, rate_hz, 1.0, kOpen);
  return -std::log(body.vx_px_per_s / speed_px_per_s);
}

// Stokes' law is v' = -k v with a constant k of the medium: the same for every speed and display.
Finding stokes(const Core& core) {
  const double slow = decay_per_s(core, 900.0, 30.0), fast = decay_per_s(core, 900.0, 240.0);
  if (slow == 0.0 && fast == 0.0) return {.remark = "this core has no drag"};
  const bool is_linear = is_close(decay_per_s(core, 1.0, 60.0), decay_per_s(core, 5000.0, 60.0), 1e-9);
  if (!is_linear) return {fast / slow, ClaimVerdict::does_not_hold, "at 60 Hz it depends on the speed"};
  if (is_close(slow, fast, 0.01)) return {fast / slow, ClaimVerdict::holds};
  return {
      fast / slow, ClaimVerdict::holds_when,
      "when the frame rate never changes: " + digits(slow) + " 1/s at 30 Hz, " + digits(fast) + " at 240"};
}

// ln v falls by the same amount each step, down to the smallest normal number.
Finding exponential(const Core& core) {
  State body{0.0, 0.0, 1000.0, 0.0};
  const double factor = core.flight(body, kSixtieth_s).vx_px_per_s / body.vx_px_per_s;
  double worst = 0.0;
  for (int step = 1; step <= 5000; ++step) {
    body = core.flight(body, kSixtieth_s);
    worst = std::max(worst, std::fabs(body.vx_px_per_s / (1000.0 * std::pow(factor, step)) - 1.0));
  }
  const State late = core.steps({0.0, 0.0, 1000.0, 0.0}, kSixtieth_s, kOpen, 800'000);
  const State later = core.steps(late, kSixtieth_s, kOpen, 1);
  return {worst, holds_if(worst < 1e-9 && factor < 1.0),
          late.vx_px_per_s == 0.0 ? "down to 0"
          : late.vx_px_per_s == later.vx_px_per_s
              ? "until it sticks at " + digits(late.vx_px_per_s) + " px/s, never 0"
              : ""};
}

// Terminal speed: the fixed point of v <- a (v + G dt).
Finding terminal_speed(const Core& core) {
  if (core.constants->gravity_px_per_s2 == 0.0) return {.remark = kNoGravity};
  const State late = core.steps({0.0, 0.0, 0.0, 0.0}, 1e-2, kOpen, 20'000);
  const State later = core.steps(late, 1e-2, kOpen, 5'000);
  const double at_240_hz = core.steps({}, kSixtieth_s / 4, kOpen, 40'000).vy_px_per_s;
  return {core.steps({}, kSixtieth_s, kOpen, 40'000).vy_px_per_s,
          holds_if(is_close(late.vy_px_per_s, later.vy_px_per_s, 1e-6)),
          "at 240 Hz it is " + digits(at_240_hz) + " px/s"};
}

Finding new_velocity(const Core& core) {
  double worst_px = 0.0;
  for (std::uint64_t draw = 0; draw < 1000; ++draw) {
    const double dt_s = random_between(1, 2 * draw, 0.0, 0.1);
    const State before{0.0, 0.0, 700.0, random_between(1, 2 * draw + 1, -2000.0, 2000.0)};
    const State after = core.flight(before, dt_s);
    worst_px = std::max({worst_px, std::fabs(after.y_px - after.vy_px_per_s * dt_s),
                         std::fabs(after.x_px - after.vx_px_per_s * dt_s)});
  }
  return {worst_px, holds_if(worst_px == 0.0)};
}

}  // namespace

std::vector<Claim> flight_claims(const Core& core) {
  return {{{"1-axes", "+x right, +y down", "y after one step from 0 with a speed to the right alone", "> 0",
            "px"},
           axes(core)},
          {{"2.1-gravity", "a constant downward acceleration is applied at the beginning of each step",
            "speed gained in a step, before drag, at three speeds and three dt",
            digits(core.constants->gravity_px_per_s2), "px/s2"},
           gravity(core)},
          {{"2.2-both-components", "both velocity components are multiplied by the drag factor",
            "factor of a difference in vx over a step", "< 1, in vy the same"},
           drag_factor(core)},
          {{"2.2-stokes", "drag models a weak linear damping (Stokes law)",
            "rate of decay in flight at 240 Hz over that at 30 Hz", "0.99 .. 1.01"},
           stokes(core)},
          {{"2.2-exponential", "the velocity decays exponentially in the absence of other forces",
            "largest relative distance from v0 a^n over 5000 steps", "< 1e-9"},
           exponential(core)},
          {{"2.2-terminal", "drag prevents indefinite acceleration under gravity",
            "speed of an endless fall at 60 Hz", "the same after 50 s more", "px/s"},
           terminal_speed(core)},
          {{"2.3-new-velocity", "the position is advanced using the new velocities",
            "largest distance of a step from dt times the new velocity, 1000 draws", "0", "px"},
           new_velocity(core)}};
}

}  // namespace hyrax

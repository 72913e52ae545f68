// Sections 3.2.2, 4.1 and 4.2: the rest threshold at several frame rates, large dt, stability, tunnelling.
#include <algorithm>

#include "sim/core/core.h"
#include "sim/result/estimate.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

constexpr int kDrops = 12;

// A drop from one of several heights, after it has ended.
State ended_drop(const Core& core, int drop, double rate_hz) {
  return state_after(core, {900.0, kDesktop.bottom_px * drop / kDrops, 0.0, 0.0}, rate_hz, 12.0);
}

// Whether all drops end at zero speed: in two rows, since the two-cycle passes 0 in every other row.
bool end_at_zero_speed(const Core& core, double rate_hz) {
  for (int drop = 0; drop < kDrops; ++drop) {
    const State body = ended_drop(core, drop, rate_hz);
    const State next = core.step(body, 1.0 / rate_hz, kDesktop);
    if (body.vy_px_per_s != 0.0 || next.vy_px_per_s != 0.0) return false;
  }
  return true;
}

// Whether all drops end exactly on the floor and stay there for a second.
bool stand_still(const Core& core, double rate_hz) {
  for (int drop = 0; drop < kDrops; ++drop) {
    State body = ended_drop(core, drop, rate_hz);
    for (int step = 0; step < static_cast<int>(rate_hz); ++step) {
      if (body.y_px != kDesktop.bottom_px) return false;
      body = core.step(body, 1.0 / rate_hz, kDesktop);
    }
  }
  return true;
}

// The rate above which drops end at zero speed, by bisection.
double zero_speed_rate_hz(const Core& core) {
  double low_hz = 20.0, high_hz = 1000.0;
  for (int halving = 0; halving < 20; ++halving) {
    const double middle_hz = 0.5 * (low_hz + high_hz);
    (end_at_zero_speed(core, middle_hz) ? high_hz : low_hz) = middle_hz;
  }
  return high_hz;
}

Finding infinite_bounce(const Core& core) {
  if (end_at_zero_speed(core, 20.0) && end_at_zero_speed(core, 60.0)) return {20.0, ClaimVerdict::holds};
  const std::string below = stand_still(core, 24.0) && stand_still(core, 60.0) && stand_still(core, 120.0)
                                ? "vy can stay nonzero, but the position stands still"
                                : "some drops keep bouncing";
  if (!end_at_zero_speed(core, 1000.0)) return {kNotGiven, ClaimVerdict::does_not_hold, below};
  const double rate_hz = zero_speed_rate_hz(core);
  return {rate_hz, ClaimVerdict::holds_when,
          "when the display is faster than " + digits(rate_hz) + " Hz; below, " + below};
}

// Stable: of every throw, the speed is at most that of the start plus what a step of gravity adds (the fixed
// point of |v| <- a b (|v| + G dt)), and the position is in the window.
bool is_stable(const Core& core, double dt_s) {
  const Constants constants = core.constants.value();
  const double c = constants.air_drag * constants.restitution;
  const double bound_px_per_s = std::max(3000.0, constants.air_drag * constants.gravity_px_per_s2 * dt_s /
                                                     (1.0 - std::min(c, 0.999999))) +
                                constants.gravity_px_per_s2 * 2.0;
  for (std::uint64_t fling = 0; fling < 20; ++fling) {
    State body = random_throw({.seed = 5, .fastest_px_per_s = 2000.0}, fling);
    for (int step = 0; step < 500; ++step) {
      body = core.step(body, dt_s, kDesktop);
      const double speed = std::max(std::fabs(body.vx_px_per_s), std::fabs(body.vy_px_per_s));
      if (!(speed <= bound_px_per_s) || !is_on_desktop(body)) return false;
    }
  }
  return true;
}

Finding stable_step(const Core& core) {
  double largest_s = 0.0;
  for (const double dt_s : {0.001, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3, 1.0, 10.0, 1e3, 1e6}) {
    if (!is_stable(core, dt_s)) break;
    largest_s = dt_s;
  }
  const bool ends_near = largest_s >= 0.02 && largest_s <= 0.05;
  return {largest_s, holds_if(ends_near), largest_s == 1e6 ? "no dt tried is unstable" : ""};
}

// Of throws at corners that cross both walls in one frame, in a range of speeds, those that come out.
Share corner_throws(const Core& core, double least_px_per_s, double most_px_per_s) {
  Share outside;
  for (std::uint64_t draw = 0; draw < 20'000; ++draw) {
    const bool is_right = split_mix64_unit(6, 5 * draw) < 0.5,
               is_low = split_mix64_unit(6, 5 * draw + 1) < 0.5;
    const double speed = random_between(6, 5 * draw + 2, least_px_per_s, most_px_per_s);
    const double inset_px = random_between(6, 5 * draw + 3, 0.0, 20.0),
                 other_px = random_between(6, 5 * draw + 4, 0.0, 20.0);
    const State body{is_right ? kDesktop.right_px - inset_px : inset_px,
                     is_low ? kDesktop.bottom_px - other_px : other_px, is_right ? speed : -speed,
                     is_low ? speed : -speed};
    const State flight = core.flight(body, kSixtieth_s);
    const bool crosses_x = flight.x_px < 0.0 || flight.x_px > kDesktop.right_px;
    const bool crosses_y = flight.y_px < 0.0 || flight.y_px > kDesktop.bottom_px;
    if (!crosses_x || !crosses_y) continue;
    outside.add(!is_on_desktop(core.step(body, kSixtieth_s, kDesktop)));
  }
  return outside;
}

// Without a throw that crosses both walls, the claim is not measured.
Finding if_crossed(const Share& outside, double number, bool holds, const std::string& none_outside) {
  if (outside.of == 0) return {.remark = "of 0"};
  return {number, holds_if(holds),
          "of " + std::to_string(outside.of) + (outside.count == 0 ? none_outside : "")};
}

}  // namespace

std::vector<Claim> time_step_claims(const Core& core) {
  const Share fast = corner_throws(core, 2000.0, 100'000.0);
  const Share slow = corner_throws(core, 100.0, 2000.0);
  return {
      {{"3.2.2-infinite-bounce", "the rest threshold eliminates the infinite bounce phenomenon",
        "frame rate above which drops from twelve heights end at zero speed", "20", "Hz"},
       infinite_bounce(core)},
      {{"4.1-stable-dt", "for stable simulation dt should not exceed about 0.02 s",
        "largest dt tried, of 0.001 to 1e6 s, up to which throws stay bounded and in the window",
        "0.02 .. 0.05", "s"},
       stable_step(core)},
      {{"4.2-tunnel",
        "a fast sprite could tunnel through a corner if it crosses both boundaries in one frame",
        "throws that came out of the window, of those that crossed both in a frame, above 2000 px/s", "> 0"},
       if_crossed(fast, static_cast<double>(fast.count), fast.count > 0, ": a clamp cannot be passed")},
      {{"4.2-rare", "below 2000 px/s tunnelling is rare", "part of such throws below 2000 px/s that came out",
        "< 0.01"},
       if_crossed(slow, slow.part(), slow.part() < 0.01, "; so rare that it never happens")}};
}

}  // namespace hyrax

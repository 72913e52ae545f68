// Sections 5 to 7: the constants of table 1; frame-rate independence, sizes, stopping, drawing; speed.
#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/reference/model.h"
#include "sim/result/estimate.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

Claim constant(const char* id, const char* sentence, double core, double paper, const char* unit) {
  const std::string remark = core != paper ? fmt::format("the paper has {}", paper) : "";
  return {{id, sentence, "the core's value", fmt::format("{}", paper), unit},
          {core, holds_if(core == paper), remark},
          false,
          true};
}

// The largest jump of a step of a slow sprite that is larger than its window by 28 and 48 px.
Finding sizes(const Core& core) {
  constexpr Bounds kNoRoom{-28, -48};
  State body{-10.0, -20.0, 1.0, 1.0};
  double jump_px = 0.0;
  for (int step = 0; step < 600; ++step) {
    const State after = core.step(body, kSixtieth_s, kNoRoom);
    jump_px = std::max({jump_px, std::fabs(after.x_px - body.x_px), std::fabs(after.y_px - body.y_px)});
    body = after;
  }
  if (jump_px <= 30.0) return {jump_px, ClaimVerdict::holds};
  return {jump_px, ClaimVerdict::holds_when,
          "when the sprite fits the window; a larger one is thrown from bound to bound"};
}

// What resetVelocity does, and how gravity moves the sprite in the second after.
Finding stopping(const Core& core) {
  const State stopped = core.stopped({900.0, 100.0, 700.0, -300.0});
  const State after = core.steps(stopped, kSixtieth_s, kOpen, 60);
  const double moved_px = std::hypot(after.x_px - stopped.x_px, after.y_px - stopped.y_px);
  if (stopped.vx_px_per_s != 0.0 || stopped.vy_px_per_s != 0.0)
    return {moved_px, ClaimVerdict::does_not_hold,
            "it leaves (" + digits(stopped.vx_px_per_s) + ", " + digits(stopped.vy_px_per_s) + ") px/s"};
  if (moved_px == 0.0) return {moved_px, ClaimVerdict::holds};
  return {moved_px, ClaimVerdict::holds_when, "when it is on the ground; in the air gravity starts it again"};
}

Finding drawing(const Core& core) {
  double least_px = 1e300;
  State body{500.0, 300.0, -2000.0, 0.0};
  for (int step = 0; step < 60; ++step) {
    body = core.step(body, kSixtieth_s, kDesktop);
    least_px = std::min(least_px, body.x_px - kSpriteSide_px / 2);
  }
  return {least_px, holds_if(least_px >= 0.0),
          least_px < 0.0 ? digits(-least_px) + " px of it are outside the window; x, y is its corner" : ""};
}

}  // namespace

std::vector<Claim> constant_claims(const Core& core) {
  const Constants constants = core.constants.value();
  const Model paper;  // The reference has its own copy of the table.
  return {
      constant("5-gravity", "GRAVITY 1200.0", constants.gravity_px_per_s2, paper.gravity_px_per_s2, "px/s2"),
      constant("5-restitution", "RESTITUTION 0.6", constants.restitution, paper.restitution, "1"),
      constant("5-air-drag", "AIR_DRAG 0.999, velocity multiplier per frame", constants.air_drag,
               paper.air_drag, "1"),
      constant("5-ground-friction", "GROUND_FRICTION 0.8", constants.ground_friction, paper.ground_friction,
               "1"),
      constant("5-rest-threshold", "REST_THRESHOLD 5.0, minimum |vy| to consider at rest",
               constants.rest_threshold_px_per_s, paper.rest_threshold_px_per_s, "px/s"),
  };
}

// Where throws settle at displays of 24 to 240 Hz.
Claim frame_rate_claim(const Core& core, const ClaimStarts& starts) {
  constexpr double kApproximately = 0.05, kMost = 0.5;
  const double allowed_px = kApproximately * kDesktop.right_px;
  std::vector<double> spreads_px;
  Share within;
  for (std::uint64_t start = 0; start < kStarts; ++start) {
    Extremes x_px;
    for (const double rate_hz : {24.0, 30.0, 60.0, 75.0, 120.0, 144.0, 165.0, 240.0})
      x_px.include(state_after(core, random_throw(starts, start), rate_hz, 20.0).x_px);
    spreads_px.push_back(x_px.most - x_px.least);
    within.add(spreads_px.back() <= allowed_px);
  }
  const ClaimVerdict verdict = within.low() > kMost    ? ClaimVerdict::holds
                               : within.high() < kMost ? ClaimVerdict::does_not_hold
                                                       : ClaimVerdict::not_measured;
  return {{"6.1-frame-rate",
           "real elapsed time ensures that the simulation remains approximately frame-rate independent",
           "spread of the resting places of a throw, 24 to 240 Hz, 100 throws",
           "<= " + digits(allowed_px) + " of most", "px"},
          finding_of(spreads_px, verdict,
                     fmt::format("{} of {} throws settle within a twentieth of the window, which would be "
                                 "approximate",
                                 within.count, within.of))};
}

std::vector<Claim> use_claims(const Core& core) {
  return {frame_rate_claim(core),
          {{"6.1-sizes",
            "the sizes of screen and sprite allow the engine to compute collision boundaries correctly",
            "largest jump in a step of a slow sprite that is 48 px higher than its window", "<= 30", "px"},
           sizes(core)},
          {{"6.1-reset", "resetVelocity sets both velocity components to zero, stopping all motion",
            "distance that a sprite stopped in the air moves in the next second", "0", "px"},
           stopping(core)},
          {{"6.2-drawing", "draw the sprite at left = x - w/2, top = y - h/2",
            "leftmost edge of a sprite of 128 px drawn so", ">= 0", "px"},
           drawing(core)}};
}

std::vector<Claim> speed_claims(double step_s) {
  constexpr double kFast = 1e-3;  // A thousandth of a frame: nobody notices it.
  const double share = step_s / kSixtieth_s;
  return {{{"7-fast", "Using C++ makes it fast",
            "time of a step, as a part of a frame of a sixtieth of a second", "< " + digits(kFast)},
           {share, holds_if(share < kFast)},
           true}};
}

}  // namespace hyrax

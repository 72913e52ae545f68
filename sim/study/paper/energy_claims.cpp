// Sections 2.3 and 2.4: energy, and the comparison with explicit Euler.
#include <algorithm>
#include <vector>

#include "sim/motion/step.h"
#include "sim/replay/core_constants.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

constexpr char kDiffersFromListing[] =
    "this core's step is not the listing's, so it cannot be measured without drag";

// The core's laws without loss.
Constants lossless() {
  return {.gravity_px_per_s2 = core_constants().gravity_px_per_s2,
          .restitution = 1.0,
          .air_drag = 1.0,
          .ground_friction = 1.0,
          .rest_threshold_px_per_s = 0.0};
}

// e = v^2 / 2 + G (bottom - y).
double energy(const State& body, Bounds bounds) {
  return (body.vx_px_per_s * body.vx_px_per_s + body.vy_px_per_s * body.vy_px_per_s) / 2 +
         core_constants().gravity_px_per_s2 * (bounds.bottom_px - body.y_px);
}

// Largest relative change of energy in lossless motion.
double lossless_drift(StepOrder order, State body, double duration_s, Bounds bounds) {
  const double first = energy(body, bounds);
  double worst = 0.0;
  for (int step = 0; step < static_cast<int>(duration_s / kSixtieth_s); ++step) {
    body = stepped(lossless(), order, body, kSixtieth_s, bounds);
    worst = std::max(worst, std::fabs(energy(body, bounds) - first));
  }
  return worst / std::fabs(first);
}

// A second of flight from vy = -900, and a minute of elastic bounces from the middle of the desktop.
double flight_drift(StepOrder order) {
  return lossless_drift(order, {500.0, 700.0, 300.0, -900.0}, 1.0, Bounds{100'000, 100'000});
}
double bouncing_drift(StepOrder order) {
  return lossless_drift(order, {500.0, 400.0, 300.0, 0.0}, 60.0, kDesktop);
}

// Symplectic Euler in a constant field loses (G dt)^2 / 2 a step: it conserves no energy, but
// e + (dt / 2) G vy exactly. (E. Hairer, C. Lubich, G. Wanner, "Geometric Numerical Integration", 2006, IX.)
Claim conservation(bool is_listing) {
  const double drift = bouncing_drift(StepOrder::paper);
  const State from{500.0, 400.0, 300.0, 0.0};
  const State flown = stepped(lossless(), StepOrder::paper, from, kSixtieth_s, kOpen);
  const double lost = energy(from, kDesktop) - energy(flown, kDesktop);
  const double gain = core_constants().gravity_px_per_s2 * kSixtieth_s;
  Claim claim{"2.3-energy",
              "it ensures energy conservation in the undamped, elastic case",
              "largest relative change of energy in a minute of lossless bounces at 60 Hz",
              "< 1e-9",
              drift,
              "1",
              holds_if(drift < 1e-9),
              "a step of flight loses " + digits(lost) + " px2/s2; (G dt)^2/2 is " + digits(gain * gain / 2)};
  if (!is_listing) claim.verdict = ClaimVerdict::not_measured, claim.remark = kDiffersFromListing;
  return claim;
}

Claim against_explicit(bool is_listing) {
  const double in_flight = flight_drift(StepOrder::paper) / flight_drift(StepOrder::position_first);
  const double in_bounces = bouncing_drift(StepOrder::paper) / bouncing_drift(StepOrder::position_first);
  constexpr double kBetter = 0.5;
  const bool is_better_in_flight = in_flight < kBetter, is_better_in_bounces = in_bounces < kBetter;
  Claim claim{"2.4-explicit",
              "a better long-term energy behavior than the standard explicit Euler integrator",
              "energy drift of lossless bounces in a minute, over that of explicit Euler",
              "< 0.5, in flight, too",
              in_bounces,
              "1",
              is_better_in_flight && is_better_in_bounces   ? ClaimVerdict::holds
              : is_better_in_flight || is_better_in_bounces ? ClaimVerdict::holds_when
                                                            : ClaimVerdict::does_not_hold,
              std::string(is_better_in_bounces  ? "when it bounces"
                          : is_better_in_flight ? "when it flies"
                                                : "neither in flight nor in bounces") +
                  "; in one flight the ratio is " + digits(in_flight)};
  if (!is_listing) claim.verdict = ClaimVerdict::not_measured, claim.remark = kDiffersFromListing;
  return claim;
}

}  // namespace

std::vector<Claim> energy_claims() {
  const bool is_listing = steps_that_differ_from_listing(5000) == 0;
  return {conservation(is_listing), against_explicit(is_listing)};
}

}  // namespace hyrax

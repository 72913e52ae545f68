// Sections 2.3 and 2.4: energy, and the comparison with explicit Euler.
#include <algorithm>
#include <vector>

#include "sim/core/core.h"
#include "sim/motion/step.h"
#include "sim/result/estimate.h"
#include "sim/study/bounces/bounces.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

// Largest relative change of energy in lossless motion.
double lossless_drift(const Core& core, StepOrder order, State body, double duration_s, Bounds bounds) {
  const Constants laws = lossless(core);
  const double first = energy(body, laws.gravity_px_per_s2, bounds);
  double worst = 0.0;
  for (int step = 0; step < static_cast<int>(duration_s / kSixtieth_s); ++step) {
    body = stepped(laws, order, body, kSixtieth_s, bounds);
    worst = std::max(worst, std::fabs(energy(body, laws.gravity_px_per_s2, bounds) - first));
  }
  return worst / std::fabs(first);
}

// A second of flight from vy = -900.
double flight_drift(const Core& core, StepOrder order) {
  return lossless_drift(core, order, {500.0, 700.0, 300.0, -900.0}, 1.0, Bounds{100'000, 100'000});
}
// Bounces on the desktop. A start with vy = 0 would keep vy on multiples of G dt, so that bounces can lock
// and nearly conserve energy: one start says nothing.
std::vector<double> bouncing_drifts(const Core& core, StepOrder order, const ClaimStarts& starts,
                                    double duration_s) {
  std::vector<double> drifts;
  for (std::uint64_t start = 0; start < kStarts; ++start)
    drifts.push_back(lossless_drift(core, order, random_throw(starts, start), duration_s, kDesktop));
  return drifts;
}

// Symplectic Euler in a constant field loses (G dt)^2 / 2 a step: it conserves no energy, but
// e + (dt / 2) G vy exactly. (E. Hairer, C. Lubich, G. Wanner, "Geometric Numerical Integration", 2006, IX.)
Finding conservation(const Core& core, const ClaimStarts& starts) {
  const State from{500.0, 400.0, 300.0, 0.0};
  const Constants laws = lossless(core);
  const State flown = stepped(laws, StepOrder::paper, from, kSixtieth_s, kOpen);
  const double lost =
      energy(from, laws.gravity_px_per_s2, kDesktop) - energy(flown, laws.gravity_px_per_s2, kDesktop);
  const double gain = laws.gravity_px_per_s2 * kSixtieth_s;
  const std::vector<double> drifts = bouncing_drifts(core, StepOrder::paper, starts, 60.0);
  return finding_of(
      drifts, holds_if(*std::max_element(drifts.begin(), drifts.end()) < 1e-9),
      "a step of flight loses " + digits(lost) + " px²/s²; (G dt)^2/2 is " + digits(gain * gain / 2));
}

// "Better" in most throws, by the 95 % interval of the share, if not in all.
Finding against_explicit(const Core& core, const ClaimStarts& starts) {
  constexpr double kLong_s = 600.0, kBetter = 0.5, kNearlyAll = 0.95;
  if (core.constants->gravity_px_per_s2 == 0.0) return {.remark = kNoGravity};
  const double in_flight =
      flight_drift(core, StepOrder::paper) / flight_drift(core, StepOrder::position_first);
  const std::vector<double> paper = bouncing_drifts(core, StepOrder::paper, starts, kLong_s),
                            euler = bouncing_drifts(core, StepOrder::position_first, starts, kLong_s);
  Share better;
  for (std::size_t start = 0; start < paper.size(); ++start) better.add(paper[start] < euler[start]);
  const bool is_better_in_flight = in_flight < kBetter;
  const bool is_better_in_bounces = better.low() > kBetter;
  const ClaimVerdict verdict = is_better_in_flight && better.low() > kNearlyAll ? ClaimVerdict::holds
                               : is_better_in_flight || is_better_in_bounces    ? ClaimVerdict::holds_when
                               : better.high() > kBetter                        ? ClaimVerdict::not_measured
                                                                                : ClaimVerdict::does_not_hold;
  const std::string where = is_better_in_bounces      ? "when it bounces, in most throws"
                            : is_better_in_flight     ? "when it flies"
                            : better.high() > kBetter ? "not decided by 100 throws"
                                                      : "neither in flight nor in bounces";
  return {better.part(),
          verdict,
          where + "; in one flight the ratio is " + digits(in_flight),
          {{better.low(), better.high()}}};
}

}  // namespace

std::vector<Claim> energy_claims(const Core& core, const ClaimStarts& starts) {
  const bool is_listing = steps_that_differ_from_listing(core, 5000) == 0;
  const Finding other{.remark =
                          "this core's step is not the listing's, so it cannot be measured without drag"};
  return {
      {{"2.3-energy", "it ensures energy conservation in the undamped, elastic case",
        "largest relative change of energy in a minute of lossless bounces at 60 Hz, 100 throws", "< 1e-9"},
       is_listing ? conservation(core, starts) : other},
      {{"2.4-explicit", "a better long-term energy behavior than the standard explicit Euler integrator",
        "part of 100 throws whose energy changes less than by explicit Euler, ten minutes of lossless "
        "bounces",
        "> 0.95, in flight less than half"},
       is_listing ? against_explicit(core, starts) : other}};
}

}  // namespace hyrax

// Bounces without loss: energies against a plain loop, and what the study says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "sim/study/bounces/bounces.h"
#include "sim/study/methods/many_flings.h"

namespace hyrax {
namespace {

// Energy after a minute at 60 Hz in parts of that at the start, without drag, friction and loss.
double kept_in_a_minute(State s, bool moves_first) {
  const auto energy_of = [](const State& at) {
    return (at.vx_px_per_s * at.vx_px_per_s + at.vy_px_per_s * at.vy_px_per_s) / 2 +
           1200.0 * (952.0 - at.y_px);
  };
  const auto bounce = [](double& place, double& speed, double bound) {
    if (place >= 0.0 && place <= bound) return;
    place = std::clamp(place, 0.0, bound);
    speed = -speed;
  };
  const double at_start = energy_of(s);
  for (int frame = 0; frame < 3600; ++frame) {
    const double vy_before = s.vy_px_per_s;
    s.vy_px_per_s += 1200.0 / 60.0;
    s.x_px += s.vx_px_per_s / 60.0;
    s.y_px += (moves_first ? vy_before : s.vy_px_per_s) / 60.0;
    bounce(s.x_px, s.vx_px_per_s, 1792.0);
    bounce(s.y_px, s.vy_px_per_s, 952.0);
  }
  return energy_of(s) / at_start;
}

TEST(Bounces, KeepTheEnergyThatAPlainLoopKeeps) {
  const ManyFlings flings({FixedRate{60.0}, {}}, 60.0, 20);
  int compared = 0;
  for (const KeptEnergy& kept : kept_energies(shipped_core(), {60.0}, 20)) {
    if (kept.method == BounceMethod::exact) {
      EXPECT_NEAR(kept.minute, 1.0, 1e-9);
      EXPECT_NEAR(kept.ten_minutes, 1.0, 1e-9);
      continue;
    }
    ++compared;
    // Some throws end in another place after a rounding error at an impact.
    const double expected =
        kept_in_a_minute(flings.start(kept.number), kept.method == BounceMethod::explicit_euler);
    EXPECT_NEAR(kept.minute, expected, 1e-6)
        << kBounceMethods[static_cast<std::size_t>(kept.method)] << ' ' << kept.number;
  }
  EXPECT_EQ(compared, 40);
}

TEST(BouncesResult, ARuleIsBrokenByExactImpactsThatLoseEnergy) {
  const KeptEnergy paper{BounceMethod::paper, 60.0, 0, 500.0, 0.5, 0.4},
      euler{BounceMethod::explicit_euler, 60.0, 0, 500.0, 1.5, 1.7},
      exact{BounceMethod::exact, 0.0, 0, 500.0, 1.0, 1.0 + 1e-10};
  EXPECT_TRUE(bounces_result({paper, euler, exact}).verdict.broken.empty());
  for (double KeptEnergy::*const part : {&KeptEnergy::minute, &KeptEnergy::ten_minutes})
    for (const auto& [kept, change] :
         {std::pair(1.0 - 1e-8, "-1e-08"), {1.0 + 1e-8, "1e-08"}, {std::nan(""), "nan"}}) {
      KeptEnergy changed = exact;
      changed.number = 7;
      changed.*part = kept;
      EXPECT_EQ(bounces_result({paper, euler, exact, changed}).verdict.broken,
                std::vector<std::string>{std::string("exact impacts: throw 7 changes its energy by ") +
                                         change + " of it, more than 1e-09"});
    }
}

}  // namespace
}  // namespace hyrax

// Bounces that lose nothing: what a step's order alone does to energy.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/study/study.h"

namespace hyrax {

/// The core's laws without drag, friction and loss at walls.
[[nodiscard]] Constants lossless(const Core& core);
/// e = v^2 / 2 + G (bottom - y), in px^2/s^2.
[[nodiscard]] double energy(const State& body, double gravity_px_per_s2, const Bounds& bounds);

enum class BounceMethod : std::uint8_t {
  paper,           ///< The paper's order: symplectic Euler.
  explicit_euler,  ///< The position moves with the old velocity.
  exact            ///< From impact to impact, without frames.
};
inline constexpr std::array<std::string_view, 3> kBounceMethods = {"paper", "explicit-euler",
                                                                   "exact-impacts"};

/// Of one throw: its energy after a minute and after ten, in parts of that at its start [-].
struct KeptEnergy {
  BounceMethod method = BounceMethod::paper;
  double rate_hz = 0.0;  ///< 0: without frames.
  std::int64_t number = 0;
  double speed_px_per_s = 0.0;  ///< At the start.
  double minute = 0.0;
  double ten_minutes = 0.0;
};

/// The first `throws` of kFlingSeed, by each method at each rate: in this order.
[[nodiscard]] std::vector<KeptEnergy> kept_energies(const Core& core, std::int64_t throws);

/// Tables, figures and verdict of the study. A rule: by exact impacts no throw changes its energy by more
/// than 1e-9 of it. REQUIRES: not empty; of a method, those of one rate stand together.
[[nodiscard]] Result bounces_result(const std::vector<KeptEnergy>& kept);

}  // namespace hyrax

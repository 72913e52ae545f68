// How a sprite ends on the floor: at which display rates, when, and after which bounces.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/estimate.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"

namespace hyrax {

/// The ways a sprite ends, by two consecutive rows. In the first three its position stands still, exactly on
/// the floor, and only vy differs: exactly 0; 0 in every other row; constant (or alternating between
/// neighbouring doubles).
enum class FinalState : std::uint8_t { zero_speed, two_cycle, residual_speed, moving };
/// In files.
inline constexpr std::array<std::string_view, 4> kFinalStateNames = {"rest", "cycle", "buzz", "moving"};
/// For readers.
[[nodiscard]] inline std::string_view text_of(FinalState state) {
  constexpr std::array<std::string_view, 4> kTexts = {"zero speed", "two-cycle", "residual speed", "moving"};
  return kTexts[static_cast<std::size_t>(state)];
}

/// A display rate at which the possible final states change, derived from the core's constants and found on
/// the core.
///
/// In (y, vy) the floor is a map. With g = drag * G * dt, b = restitution, a = drag and the threshold e:
///   0 stays 0 where b g < e;
///   the residual speed -b g / (1 + a b) stays above the threshold where b g / (1 + a b) >= e;
///   the two-cycle 0, -b g, 0 comes back to 0 where b g (1 - a b) < e.
struct RestBoundary {
  std::string name;  ///< In files.
  std::string text;  ///< For readers.
  double analytic_hz = 0.0;
  std::optional<double> measured_hz;  ///< None where the core has no such boundary.
  [[nodiscard]] bool agrees() const;
};
[[nodiscard]] std::vector<RestBoundary> rest_boundaries(const Core& core);

inline constexpr double kRestPlayed_s = 15.0;  ///< The paper's constants let any fling settle before.

/// Random flings (ManyFlings) at one rate, each for so long.
struct RateEnds {
  double rate_hz = 0.0;
  double gain_px_per_s = 0.0;  ///< Speed that one step of gravity adds, after drag.
  std::array<std::int64_t, kFinalStateNames.size()> flings{};  ///< By FinalState.
  std::int64_t unforeseen = 0;         ///< Flings that settled in a state that the boundaries do not allow.
  std::optional<Band> settles_s = {};  ///< Since when they have settled; none if no fling has.

  [[nodiscard]] std::int64_t count(FinalState state) const { return flings[static_cast<std::size_t>(state)]; }
  [[nodiscard]] std::int64_t total() const {
    return std::accumulate(flings.begin(), flings.end(), std::int64_t{0});
  }
  [[nodiscard]] Share share(FinalState state) const { return {count(state), total()}; }
  [[nodiscard]] double percent(FinalState state) const {
    return 100.0 * static_cast<double>(count(state)) / static_cast<double>(total());
  }
};
/// @param flings the same at each rate. REQUIRES: at least one.
[[nodiscard]] std::vector<RateEnds> rest_map(const Core& core, const std::vector<double>& rates_hz,
                                             std::int64_t flings);

/// The first bounce of a drop.
struct DropBounce {
  double rate_hz = 0.0;
  double phase = 0.0;        ///< Part of the contact's step below the floor, 0 .. 1.
  double restitution = 0.0;  ///< Speed after the contact over the speed of the exact impact.
};
[[nodiscard]] std::vector<DropBounce> bounces_at(const Core& core, double rate_hz, std::int64_t phases);

struct RestResults {
  std::vector<RestBoundary> boundaries = {};
  std::vector<RateEnds> map = {};
  std::vector<DropBounce> bounces = {};
};

/// Of two rows in kDesktop, one frame apart.
[[nodiscard]] FinalState final_state(const Core& core, const State& row, const State& next, double rate_hz);

/// Final states against the display rate, time to settle against the display rate, effective restitution
/// against the phase of the contact.
[[nodiscard]] std::vector<Figure> rest_figures(const Core& core, const RestResults& results);

/// What is printed of them. Broken: boundaries elsewhere than derived, final states that they do not allow,
/// and flings that still move.
[[nodiscard]] Verdict rest_verdict(const RestResults& results);

}  // namespace hyrax

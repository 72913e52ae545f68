// How a sprite ends on the floor: at which display rates, when, and after which bounces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/study/methods/core.h"
#include "sim/result/table.h"

namespace hyrax {

/// By value of two rows on the floor, one after the other: the buzz may alternate between neighbouring
/// doubles.
enum class FinalState : std::uint8_t { rest, cycle, buzz, moving };
inline constexpr std::array<std::string_view, 4> kFinalStateNames = {"rest", "cycle", "buzz", "moving"};

/// A display rate at which the ways to end change, derived from the core's constants and found on the core.
///
/// In (y, vy) the floor is a map. With g = drag * G * dt, b = restitution, a = drag and the threshold e:
///   0 stays 0 where b g < e;
///   the fixed buzz -b g / (1 + a b) keeps above the threshold where b g / (1 + a b) >= e;
///   the cycle 0, -b g, 0 comes back to 0 where b g (1 - a b) < e.
struct RestBoundary {
  std::string name;
  double analytic_hz = 0.0;
  std::optional<double> measured_hz;  ///< None where the core has no such boundary.
  [[nodiscard]] bool agrees() const;
};
[[nodiscard]] std::vector<RestBoundary> rest_boundaries();

/// Random flings at one rate.
struct RateEnds {
  double rate_hz = 0.0;
  double gain_px_per_s = 0.0;                                  ///< What a step of gravity gives after drag.
  std::array<std::int64_t, kFinalStateNames.size()> flings{};  ///< By FinalState.
  std::int64_t unforeseen = 0;  ///< Flings that ended in a way that the boundaries do not allow.
  double time_low_s = 0.0;      ///< Until the last row that is off the floor by 0.5 px: first decile,
  double time_median_s = 0.0;
  double time_high_s = 0.0;  ///< and last.
};
/// So many flings of every height and speed, the same at each rate.
[[nodiscard]] std::vector<RateEnds> rest_map(const std::vector<double>& rates_hz, std::int64_t flings);

/// One bounce of a drop: its speed after the contact over the speed at which the exact flight meets the
/// floor.
struct BounceSeen {
  double rate_hz = 0.0;
  double phase = 0.0;  ///< Part of the contact's step that lies past the floor, 0 .. 1.
  double restitution = 0.0;
};
[[nodiscard]] std::vector<BounceSeen> bounces_at(double rate_hz, std::int64_t phases);

/// REQUIRES: two rows of a sprite, one frame apart.
[[nodiscard]] FinalState final_state(const State& row, const State& next, double rate_hz, double bottom_px);

[[nodiscard]] Table rest_map_table(const std::vector<RateEnds>& map);
[[nodiscard]] Table rest_boundary_table(const std::vector<RestBoundary>& boundaries);
[[nodiscard]] Table bounce_table(const std::vector<BounceSeen>& bounces);

}  // namespace hyrax

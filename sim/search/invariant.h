// What must hold in every step of every run, however hard.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace hyrax {

enum class Invariant : std::uint8_t {
  finite,
  in_bounds,
  step_energy,
  energy_ceiling,
  speed,
  listing,
  mirror,
  no_time,
  resumed,
  repeated,
  comes_to_rest,  ///< These five are of a hard case only.
  stays_at_rest,
  keeps_energy,
  exact_corner,
  expectations,
};
inline constexpr std::size_t kInvariantCount = 15;

struct InvariantText {
  std::string_view name;  ///< In tables and in JSON.
  std::string_view rule;  ///< What must hold, in a few words.
  std::string_view unit;  ///< Of its slack.
};

inline constexpr std::array<InvariantText, kInvariantCount> kInvariantTexts = {{
    {"finite", "state and time are finite, time does not go back", "decades"},
    {"in-bounds", "inside the window after a step, if the sprite fits into it", "px"},
    {"step-energy", "flight adds no energy, a clamp no more than its lift", "px2/s2"},
    {"energy-ceiling", "energy never above that after the last input, or of residual speed", "px2/s2"},
    {"speed", "no faster than the same fling in endless free fall", "px/s"},
    {"listing", "every step is the paper's with the core's constants, bit for bit", "px or px/s"},
    {"mirror", "left and right exchanged: the same contacts, to rounding", "px"},
    {"no-time", "a zero-length frame changes nothing", "px/s"},
    {"resumed", "stopped and resumed: the same bits as without a stop", "1"},
    {"repeated", "run twice: the same bits, repetition skipped or not", "1"},
    {"comes-to-rest", "left alone, it settles and ends at zero speed", "px/s"},
    {"stays-at-rest", "at rest, it stays within half a pixel, however long frames are", "s"},
    {"keeps-energy", "bounces without loss keep half of the energy", "1"},
    {"exact-corner", "the exact fling meets both walls at one time, stays inside, gains no energy", "px"},
    {"expectations", "what the scenario itself expects", "1"},
}};

[[nodiscard]] constexpr const InvariantText& text_of(Invariant invariant) {
  return kInvariantTexts[static_cast<std::size_t>(invariant)];
}

/// An invariant over a run. Its slack is the distance to its bound: it holds with 0 or more.
struct InvariantMeasure {
  bool is_checked = false;
  bool holds = true;
  double slack = std::numeric_limits<double>::infinity();  ///< The smallest.
  std::int64_t worst_step = -1;                            ///< Row number of the smallest.

  /// A NaN does not hold, and nothing is worse than it.
  void add(double step_slack, std::int64_t step) {
    is_checked = true;
    if (!(step_slack >= 0.0)) holds = false;
    if (slack != slack || step_slack >= slack) return;
    slack = step_slack + 0.0;  // No -0.
    worst_step = step;
  }
};

using InvariantMeasures = std::array<InvariantMeasure, kInvariantCount>;

}  // namespace hyrax

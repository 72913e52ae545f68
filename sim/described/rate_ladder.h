// One scenario at many frame rates, by any core that describes itself: how far each run is from that of the
// finest rate.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/described/described_comparison.h"

namespace hyrax {

/// The rate whose run stands for no frames at all.
inline constexpr double kFinestRate_hz = 2000.0;
/// Each is half the next; the last is half the finest.
inline constexpr std::array<double, 4> kDoubledRates_hz = {125.0, 250.0, 500.0, 1000.0};

/// A run at one rate.
struct RateRun {
  double rate_hz = 0.0;
  /// The largest distance, in px, from the run of the finest rate, at equal times; nothing: it cannot be
  /// told.
  std::optional<double> off_px = {};
  DescribedSummary summary = {};
};

struct RateLadder {
  double until_s = 0.0;            ///< Played for so long,
  bool is_cut = false;             ///< which is less than the scenario's length.
  bool has_hitches = false;        ///< The scenario's, which belong to its own frames and are left out.
  std::vector<RateRun> runs = {};  ///< In the order of the rates that were asked for; the finest is the last.
  /// Of each of kDoubledRates_hz: the largest distance from the run at twice its rate.
  std::vector<double> doubling_px = {};

  /// How many times less each doubling of the rate changes the run than the one before: 2 of a method of
  /// first order. By least squares of the logarithms; infinite where the last one changes nothing.
  [[nodiscard]] double gain() const;
  /// Whether doublings change it less and less, beyond the chance of where impacts fall in a frame.
  [[nodiscard]] bool converges() const { return gain() >= 1.4; }
};

/// Why a scenario cannot be played at other rates, as "an input has a value for each frame"; empty: it can.
[[nodiscard]] std::string why_one_rate(const DescribedScenario& scenario);

/// Plays it at each rate with even frames; events keep their times. At most 60 s, and less of many values.
/// REQUIRES: has_px; why_one_rate is empty.
[[nodiscard]] RateLadder climb(const DescribedCore& core, const DescribedScenario& scenario,
                               const std::vector<double>& rates_hz);

}  // namespace hyrax

// One scenario at many frame rates, by any core: how far each run is from that of the finest rate.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hyrax {

/// The rate whose run stands for no frames at all.
inline constexpr double kFinestRate_hz = 2000.0;
/// Each is half the next; the last is half the finest.
inline constexpr std::array<double, 4> kDoubledRates_hz = {125.0, 250.0, 500.0, 1000.0};

/// A run at one rate.
struct RateRun {
  double rate_hz = 0.0;
  /// The largest distance, in px, from the run of the finest rate, at equal times; nothing: one of both ends
  /// early.
  std::optional<double> off_px = {};
  std::int64_t contacts = 0;
  std::optional<double> at_rest_since_s = {};
  std::vector<std::string> faults = {};  ///< Why it does not hold, sentences.
};

struct RateLadder {
  std::string scenario = {};       ///< Its name.
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

/// Plays a scenario at each rate.
/// @param play_at (rate in Hz, RateRun& that takes what is to be said of the run) gives the run; nothing: it
/// ends early.
/// @param distance_px (run, run) in px, at equal times.
void climb(RateLadder& ladder, const std::vector<double>& rates_hz, const auto& play_at,
           const auto& distance_px) {
  const auto distance = [&](const auto& a, const auto& b) {
    return a && b ? distance_px(*a, *b) : std::optional<double>();
  };
  RateRun of_finest{.rate_hz = kFinestRate_hz};
  const auto finest = play_at(kFinestRate_hz, of_finest);
  if (finest) of_finest.off_px = 0.0;
  for (const double rate_hz : rates_hz) {
    RateRun& run = ladder.runs.emplace_back(RateRun{.rate_hz = rate_hz});
    run.off_px = distance(finest, play_at(rate_hz, run));
  }
  ladder.runs.push_back(std::move(of_finest));
  RateRun unsaid;
  auto coarse = play_at(kDoubledRates_hz.front(), unsaid);
  for (const double rate_hz : kDoubledRates_hz) {
    auto fine = play_at(2.0 * rate_hz, unsaid);
    ladder.doubling_px.push_back(distance(fine, coarse).value_or(HUGE_VAL));
    coarse = std::move(fine);
  }
}

}  // namespace hyrax

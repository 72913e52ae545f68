// One scenario at many frame rates, by any core: how far each run is from that of the finest rate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// The rate whose run stands for no frames at all.
inline constexpr double kFinestRate_hz = 2000.0;
/// Each is half the next; the last is half the finest.
inline constexpr std::array<double, 4> kDoubledRates_hz = {125.0, 250.0, 500.0, 1000.0};

/// A run at one rate.
struct RateRun {
  double rate_hz = 0.0;
  /// The largest distance, in px, from the run by the scenario's own clock, at equal times; nothing: one of
  /// both ends early, or has too many frames.
  std::optional<double> own_px = {};
  std::optional<double> off_px = {};  ///< The same from the run of the finest rate.
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
  [[nodiscard]] bool converges() const { return gain() >= 1.4 && is_falling(); }
  /// Whether that is not decided: less overall, but not at every doubling.
  [[nodiscard]] bool is_undecided() const { return gain() >= 1.4 && !is_falling(); }

 private:
  [[nodiscard]] bool is_falling() const {
    const auto is_not_less = [](double coarse, double fine) { return fine > 0.0 && coarse <= fine; };
    return std::ranges::adjacent_find(doubling_px, is_not_less) == doubling_px.end();
  }
};

inline double RateLadder::gain() const {
  if (doubling_px.back() == 0.0) return HUGE_VAL;
  const double middle = 0.5 * static_cast<double>(doubling_px.size() - 1);
  double slope = 0.0, square = 0.0;
  for (std::size_t index = 0; index < doubling_px.size(); ++index) {
    const double place = static_cast<double>(index) - middle;
    slope += place * std::log2(doubling_px[index]);
    square += place * place;
  }
  return std::exp2(-slope / square);
}

/// The scenario with its events by time, for any rate, up to `until_most_s`, whatever comes behind it; says
/// in `ladder` what is left out. @param event_frames of its events.
template <class AnyScenario>
[[nodiscard]] AnyScenario by_time(const AnyScenario& scenario, const std::vector<std::int64_t>& event_frames,
                                  double until_most_s, RateLadder& ladder) {
  AnyScenario timed = scenario;
  timed.events.clear();
  const FrameClock clock(scenario.clock);
  constexpr std::int64_t kFramesMost = 10'000'000;  // Frames without time never come to an end.
  const std::int64_t steps = step_count(scenario);
  std::size_t event = 0;
  Timeline timeline;
  std::int64_t frame = 0;
  for (; frame < std::min(steps, kFramesMost) && timeline.time_s() < until_most_s;
       timeline.play(clock.dt_s(frame++)))
    for (; event < event_frames.size() && event_frames[event] == frame; ++event) {
      if (std::holds_alternative<Hitch>(scenario.events[event].action))
        ladder.has_hitches = true;
      else
        timed.events.push_back({timeline.time_s(), scenario.events[event].action});
    }
  ladder.scenario = scenario.name;
  ladder.until_s = std::min(timeline.time_s(), until_most_s);
  ladder.is_cut = frame < steps || ladder.until_s < timeline.time_s();
  timed.length = ladder.until_s;
  return timed;
}

/// The scenario by even frames of that rate, or by its own clock; nothing: it has more frames, or is a trace
/// that was cut. @param timed of by_time.
template <class AnyScenario>
[[nodiscard]] std::optional<AnyScenario> at_rate(std::optional<double> rate_hz, const AnyScenario& scenario,
                                                 AnyScenario timed, const RateLadder& ladder,
                                                 double frames_most) {
  if (rate_hz) {
    timed.clock = {FixedRate{*rate_hz}, {}};
    return timed;
  }
  if (!ladder.is_cut)
    timed = scenario;
  else if (std::holds_alternative<RecordedSteps>(scenario.clock.base))
    return std::nullopt;
  if (static_cast<double>(step_count(timed)) > frames_most) return std::nullopt;
  return timed;
}

/// Plays a scenario at each rate.
/// @param play_at (rate in Hz, or nothing for the scenario as it is; RateRun& that takes what is to be said
/// of the run) gives the run; nothing: it ends early, or has too many frames.
/// @param distance_px (run, run) in px, at equal times.
void climb(RateLadder& ladder, const std::vector<double>& rates_hz, const auto& play_at,
           const auto& distance_px) {
  const auto distance = [&](const auto& a, const auto& b) {
    return a && b ? distance_px(*a, *b) : std::optional<double>();
  };
  RateRun unsaid;
  const auto own = play_at(std::nullopt, unsaid);
  RateRun of_finest{.rate_hz = kFinestRate_hz};
  const auto finest = play_at(kFinestRate_hz, of_finest);
  if (finest) of_finest.off_px = 0.0;
  of_finest.own_px = distance(own, finest);
  for (const double rate_hz : rates_hz) {
    RateRun& run = ladder.runs.emplace_back(RateRun{.rate_hz = rate_hz});
    const auto played = play_at(rate_hz, run);
    run.own_px = distance(own, played);
    run.off_px = distance(finest, played);
  }
  ladder.runs.push_back(std::move(of_finest));
  auto coarse = play_at(kDoubledRates_hz.front(), unsaid);
  for (const double rate_hz : kDoubledRates_hz) {
    auto fine = play_at(2.0 * rate_hz, unsaid);
    ladder.doubling_px.push_back(distance(fine, coarse).value_or(HUGE_VAL));
    coarse = std::move(fine);
  }
}

}  // namespace hyrax

#include "sim/described/rate_ladder.h"

#include <algorithm>
#include <cmath>

#include "sim/described/scripted_body.h"

namespace hyrax {
namespace {

constexpr double kUntilMost_s = 60.0;
constexpr double kWordsMost = 2e7;  // Of the rows of a run that is kept.

// Without a clock of its own: by time, up to `until_most_s`, whatever comes behind it.
DescribedScenario by_time(const DescribedScenario& scenario, RateLadder& ladder, double until_most_s) {
  DescribedScenario timed = scenario;
  timed.events.clear();
  const FrameClock clock(scenario.clock);
  const std::int64_t steps = step_count(scenario);
  const std::vector<TimedEvent> events = timed_events(scenario, steps);
  auto event = events.begin();
  Timeline timeline;
  std::int64_t frame = 0;
  for (; frame < steps && timeline.time_s() < until_most_s; timeline.play(clock.dt_s(frame++)))
    for (; event != events.end() && event->frame == frame; ++event) {
      if (std::holds_alternative<Hitch>(*event->action))
        ladder.has_hitches = true;
      else
        timed.events.push_back({timeline.time_s(), *event->action});
    }
  ladder.until_s = std::min(timeline.time_s(), until_most_s);
  ladder.is_cut = frame < steps || ladder.until_s < timeline.time_s();
  timed.length = ladder.until_s;
  return timed;
}

struct Played : DescribedSink {
  ComparedSide side = {};
  DescribedRows rows = {};
  DescribedSummary summary = {};

  void row(const DescribedRow& row) override { rows.append(row); }
  void contact(const DescribedContact& contact) override { side.contacts.push_back(contact); }
};

void play_at(double rate_hz, const DescribedCore& core, DescribedScenario scenario, Played& played) {
  scenario.clock = {FixedRate{rate_hz}, {}};
  DescribedSink* const sinks[] = {&played};
  played.summary = play(core, scenario, sinks);
  played.side.rows = batches_of(played.rows);
  // An event falls into the frame before, too: runs of finer rates have it there.
  for (const std::int64_t frame : jump_frames(scenario, played.summary.steps))
    for (const std::int64_t each : {frame - 1, frame})
      if (each >= 0 && (played.side.jumps.empty() || played.side.jumps.back() < each))
        played.side.jumps.push_back(each);
}

}  // namespace

double RateLadder::gain() const {
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

std::string why_one_rate(const DescribedScenario& scenario) {
  return scenario.input_arrays.empty() ? "" : "an input has a value for each frame";
}

RateLadder climb(const DescribedCore& core, const DescribedScenario& scenario,
                 const std::vector<double>& rates_hz) {
  RateLadder ladder;
  const double words = static_cast<double>(core.description.state.values.size() + 2) * kFinestRate_hz;
  const DescribedScenario timed = by_time(scenario, ladder, std::min(kUntilMost_s, kWordsMost / words));
  const auto distance_px = [&](const Played& a, const Played& b) {
    return compare_runs(core.description, a.side, b.side).max_px();
  };
  Played finest;
  play_at(kFinestRate_hz, core, timed, finest);
  for (const double rate_hz : rates_hz) {
    Played played;
    play_at(rate_hz, core, timed, played);
    ladder.runs.push_back({rate_hz, distance_px(finest, played), std::move(played.summary)});
  }
  ladder.runs.push_back({kFinestRate_hz, 0.0, std::move(finest.summary)});
  Played coarse;
  play_at(kDoubledRates_hz.front(), core, timed, coarse);
  for (const double rate_hz : kDoubledRates_hz) {
    Played fine;
    play_at(2.0 * rate_hz, core, timed, fine);
    ladder.doubling_px.push_back(distance_px(fine, coarse).value_or(HUGE_VAL));
    coarse.rows = std::move(fine.rows);
    coarse.side = std::move(fine.side);
  }
  return ladder;
}

}  // namespace hyrax

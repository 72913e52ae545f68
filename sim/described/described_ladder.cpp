#include "sim/described/described_ladder.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <variant>

#include "sim/described/scripted_body.h"

namespace hyrax {
namespace {

constexpr double kUntilMost_s = 60.0;
constexpr double kWordsMost = 2e7;  // Of the rows of a run that is kept.

// With its events by time, for any rate, up to `until_most_s`, whatever comes behind it; `ladder` has what is
// left out.
DescribedScenario by_time(const DescribedScenario& scenario, double until_most_s, RateLadder& ladder) {
  DescribedScenario timed = scenario;
  timed.events.clear();
  const FrameClock clock(scenario.clock);
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> event_frames = hyrax::event_frames(scenario, steps);
  std::size_t event = 0;
  Timeline timeline;
  std::int64_t frame = 0;
  for (; frame < steps && timeline.time_s() < until_most_s; timeline.play(clock.dt_s(frame++)))
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

class Keeper : public DescribedSink {
 public:
  void row(const DescribedRow& row) override { rows_.append(row); }
  void contact(const DescribedContact& contact) override { side_.contacts.push_back(contact); }

  [[nodiscard]] ComparedSide kept(const DescribedScenario& scenario, std::int64_t steps) {
    // An event falls into the frame before, too: runs of finer rates have it there. So does one behind the
    // end.
    for (const std::int64_t frame : jump_frames(scenario, steps + 1))
      for (const std::int64_t each : {frame - 1, frame})
        if (each >= 0 && (side_.jumps.empty() || side_.jumps.back() < each)) side_.jumps.push_back(each);
    side_.rows = batches_of(rows_);
    return std::move(side_);
  }

 private:
  DescribedRows rows_ = {};
  ComparedSide side_ = {};
};

}  // namespace

std::string why_one_rate(const DescribedScenario& scenario) {
  return scenario.input_arrays.empty() ? "" : "an input has a value for each frame";
}

RateLadder climb(const DescribedCore& core, const DescribedScenario& scenario,
                 const std::vector<double>& rates_hz,
                 const std::function<std::vector<std::string>(const DescribedSummary&)>& faults_of) {
  RateLadder ladder;
  const double words = static_cast<double>(core.description.state.values.size() + 2) * kFinestRate_hz;
  DescribedScenario timed = by_time(scenario, std::min(kUntilMost_s, kWordsMost / words), ladder);
  const auto play_at = [&](double rate_hz, RateRun& run) {
    timed.clock = {FixedRate{rate_hz}, {}};
    Keeper keeper;
    DescribedSink* const sinks[] = {&keeper};
    const DescribedSummary summary = play(core, timed, sinks);
    run.contacts = std::accumulate(summary.contacts.begin(), summary.contacts.end(), std::int64_t{0});
    run.at_rest_since_s = summary.at_rest_since_s;
    if (faults_of) run.faults = faults_of(summary);
    return summary.early_end ? std::nullopt : std::optional(keeper.kept(timed, summary.steps));
  };
  hyrax::climb(ladder, rates_hz, play_at, [&](const ComparedSide& a, const ComparedSide& b) {
    return compare_runs(core.description, a, b).max_px();
  });
  return ladder;
}

}  // namespace hyrax

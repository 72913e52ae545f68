#include "sim/described/described_ladder.h"

#include <algorithm>
#include <numeric>

#include "sim/described/scripted_body.h"

namespace hyrax {
namespace {

constexpr double kUntilMost_s = 60.0;
constexpr double kWordsMost = 2e7;  // Of the rows of a run that is kept.

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
  const double frames_most = kWordsMost / static_cast<double>(core.description.state.values.size() + 2);
  const DescribedScenario timed = by_time(scenario, event_frames(scenario, step_count(scenario)),
                                          std::min(kUntilMost_s, frames_most / kFinestRate_hz), ladder);
  const auto play_at = [&](std::optional<double> rate_hz, RateRun& run) -> std::optional<ComparedSide> {
    const std::optional<DescribedScenario> played = at_rate(rate_hz, scenario, timed, ladder, frames_most);
    if (!played) return std::nullopt;
    Keeper keeper;
    DescribedSink* const sinks[] = {&keeper};
    const DescribedSummary summary = play(core, *played, sinks);
    run.contacts = std::accumulate(summary.contacts.begin(), summary.contacts.end(), std::int64_t{0});
    run.at_rest_since_s = summary.at_rest_since_s;
    if (faults_of) run.faults = faults_of(summary);
    if (summary.early_end) return std::nullopt;
    return keeper.kept(*played, summary.steps);
  };
  hyrax::climb(ladder, rates_hz, play_at, [&](const ComparedSide& a, const ComparedSide& b) {
    return compare_runs(core.description, a, b).max_px();
  });
  return ladder;
}

}  // namespace hyrax

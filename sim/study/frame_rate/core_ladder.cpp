#include "sim/study/frame_rate/core_ladder.h"

#include "sim/compare/equal_times.h"
#include "sim/replay/replay.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

class KeptRows final : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { rows.append(row); }

  Columns rows = {};
};

}  // namespace

RateLadder climb(const Core& core, const Scenario& scenario, const std::vector<double>& rates_hz) {
  constexpr double kUntilMost_s = 60.0;
  RateLadder ladder;
  Scenario timed =
      by_time(scenario, schedule_events(scenario, step_count(scenario)).frames, kUntilMost_s, ladder);
  const auto play_at = [&](double rate_hz, RateRun& run) {
    timed.clock = {FixedRate{rate_hz}, {}};
    KeptRows kept;
    const RunSummary summary = replay(core, timed, kept);
    run.contacts = summary.contacts.total();
    run.at_rest_since_s = summary.at_rest_since_s;
    if (summary.non_finite_step)
      run.faults.push_back("not finite at step " + std::to_string(*summary.non_finite_step));
    // An input falls into the frame before, too: runs of finer rates have it there.
    std::vector<Input> inputs;
    for (const Input& input : inputs_of(timed, summary.steps))
      for (const std::int64_t frame : {input.frame - 1, input.frame})
        if (frame >= 0) inputs.push_back({frame, input.action});
    return summary.non_finite_step ? std::nullopt
                                   : std::optional(TimedRun{batches_of(kept.rows), std::move(inputs)});
  };
  hyrax::climb(ladder, rates_hz, play_at, [](const TimedRun& a, const TimedRun& b) {
    return std::optional(walk_equal_times(a, b).px());
  });
  return ladder;
}

}  // namespace hyrax

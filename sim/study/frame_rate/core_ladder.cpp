#include "sim/study/frame_rate/frame_rate.h"

#include <algorithm>

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
  constexpr double kOwnFramesMost = 1e6;
  RateLadder ladder;
  const Scenario timed =
      by_time(scenario, schedule_events(scenario, step_count(scenario)).frames, kUntilMost_s, ladder);
  const auto play_at = [&](std::optional<double> rate_hz, RateRun& run) -> std::optional<TimedRun> {
    std::optional<Scenario> played = at_rate(rate_hz, scenario, timed, ladder, kOwnFramesMost);
    if (!played) return std::nullopt;
    // Those behind its last frame are not done.
    const std::vector<std::int64_t> frames = schedule_events(*played, step_count(*played)).frames;
    played->events.erase(played->events.begin() + (std::ranges::find(frames, -1) - frames.begin()),
                         played->events.end());
    KeptRows kept;
    const RunSummary summary = replay(core, *played, kept);
    run.contacts = summary.contacts.total();
    run.at_rest_since_s = summary.at_rest_since_s;
    if (summary.non_finite_step)
      run.faults.push_back("not finite at step " + std::to_string(*summary.non_finite_step));
    // An input falls into the frame before, too: runs of finer rates have it there.
    std::vector<Input> inputs;
    for (const Input& input : inputs_of(*played, summary.steps))
      for (const std::int64_t frame : {input.frame - 1, input.frame})
        if (frame >= 0) inputs.push_back({frame, input.action});
    if (summary.non_finite_step) return std::nullopt;
    return TimedRun{batches_of(kept.rows), std::move(inputs)};
  };
  hyrax::climb(ladder, rates_hz, play_at, [](const TimedRun& a, const TimedRun& b) {
    return std::optional(walk_equal_times(a, b).px());
  });
  return ladder;
}

}  // namespace hyrax

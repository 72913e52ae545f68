#include "sim/study/frame_rate/core_ladder.h"

#include "sim/compare/equal_times.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

class KeptRows final : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { rows.append(row); }

  Columns rows = {};
};

}  // namespace

RateLadder climb(const Core& core, const Scenario& fling, const std::vector<double>& rates_hz) {
  RateLadder ladder{.scenario = fling.name, .until_s = std::get<double>(fling.length)};
  Scenario timed = fling;
  const auto play_at = [&](double rate_hz, RateRun& run) {
    timed.clock = {FixedRate{rate_hz}, {}};
    KeptRows kept;
    const RunSummary summary = replay(core, timed, kept);
    run.contacts = summary.contacts.total();
    run.at_rest_since_s = summary.at_rest_since_s;
    if (summary.non_finite_step)
      run.faults.push_back("not finite at step " + std::to_string(*summary.non_finite_step));
    return summary.non_finite_step ? std::nullopt : std::optional(TimedRun{batches_of(kept.rows), {}});
  };
  hyrax::climb(ladder, rates_hz, play_at, [](const TimedRun& a, const TimedRun& b) {
    return std::optional(walk_equal_times(a, b).px());
  });
  return ladder;
}

}  // namespace hyrax

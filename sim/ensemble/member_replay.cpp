#include <cmath>

#include "sim/ensemble/ensemble.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

// The extremes of all rows. A row replaces one only if it is strictly beyond it.
class ExtremesSink final : public RowSink {
 public:
  explicit ExtremesSink(const Scenario& scenario)
      : x_min_px_(scenario.start.x_px),
        x_max_px_(scenario.start.x_px),
        y_min_px_(scenario.start.y_px),
        y_max_px_(scenario.start.y_px) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void rows(const Columns& batch) override {
    for (std::size_t row = 0; row < batch.size(); ++row) {
      const double x_px = batch.x_px[row];
      const double y_px = batch.y_px[row];
      const double vx = batch.vx_px_per_s[row];
      const double vy = batch.vy_px_per_s[row];
      if (x_px < x_min_px_) x_min_px_ = x_px;
      if (x_px > x_max_px_) x_max_px_ = x_px;
      if (y_px < y_min_px_) y_min_px_ = y_px;
      if (y_px > y_max_px_) y_max_px_ = y_px;
      const double squared = vx * vx + vy * vy;
      if (squared > speed_squared_max_) speed_squared_max_ = squared;
    }
  }
  void write(MemberResult& result) const {
    result.x_min_px = x_min_px_;
    result.x_max_px = x_max_px_;
    result.y_min_px = y_min_px_;
    result.y_max_px = y_max_px_;
    result.speed_max_px_per_s = std::sqrt(speed_squared_max_);
  }

 private:
  double x_min_px_, x_max_px_, y_min_px_, y_max_px_;
  double speed_squared_max_ = 0.0;
};

}  // namespace

StepTally play_member(const Core& core, const Scenario& scenario, const KeepSet& keep, MemberResult& result) {
  ExtremesSink extremes(scenario);
  std::vector<RowSink*> sinks;
  if (keep.has(Keep::extremes)) sinks.push_back(&extremes);
  const RunSummary summary = replay(core, scenario, sinks);
  result.final = state_of(summary.final);
  result.contacts = summary.contacts;
  result.at_rest_since_s = summary.at_rest_since_s.value_or(std::numeric_limits<double>::quiet_NaN());
  result.state_hash = summary.state_hash;
  if (keep.has(Keep::extremes)) extremes.write(result);
  return {summary.steps, summary.steps_computed};
}

}  // namespace hyrax

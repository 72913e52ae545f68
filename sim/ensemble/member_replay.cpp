#include <cmath>

#include "sim/ensemble/ensemble.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

class ExtremesSink final : public RowSink {
 public:
  explicit ExtremesSink(MemberResult& result) : result_(result) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { result_.include(state_of(row)); }

 private:
  MemberResult& result_;
};

}  // namespace

void MemberResult::begin_extremes(const State& start) {
  x_min_px = x_max_px = start.x_px;
  y_min_px = y_max_px = start.y_px;
  speed_max_px_per_s = 0.0;
  include(start);
}

void MemberResult::include(const State& row) {
  if (row.x_px < x_min_px) x_min_px = row.x_px;
  if (row.x_px > x_max_px) x_max_px = row.x_px;
  if (row.y_px < y_min_px) y_min_px = row.y_px;
  if (row.y_px > y_max_px) y_max_px = row.y_px;
  const double squared = row.vx_px_per_s * row.vx_px_per_s + row.vy_px_per_s * row.vy_px_per_s;
  if (squared > speed_max_px_per_s) speed_max_px_per_s = squared;
}

StepTally play_member(const Core& core, const Scenario& scenario, const KeepSet& keep, MemberResult& result) {
  ExtremesSink extremes(result);
  result.begin_extremes(start_state(scenario));
  std::vector<RowSink*> sinks;
  if (keep.has(Keep::extremes)) sinks.push_back(&extremes);
  const RunSummary summary = replay(core, scenario, sinks);
  result.final = state_of(summary.final);
  result.contacts = summary.contacts;
  result.at_rest_since_s = summary.at_rest_since_s.value_or(std::numeric_limits<double>::quiet_NaN());
  result.state_hash = summary.state_hash;
  result.speed_max_px_per_s = std::sqrt(result.speed_max_px_per_s);
  return {summary.steps, summary.steps_computed};
}

}  // namespace hyrax

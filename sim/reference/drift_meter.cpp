#include "sim/reference/drift_meter.h"

namespace hyrax {

void DriftMeter::row(const Row& row) {
  if (is_over_) return;
  cutter_.row(row);
  if (periods_) judge_period(row.step);
}

// Complete periods are looked at only where skipping them saves time.
void DriftMeter::repeats(const Repetition& repetition) {
  constexpr std::int64_t kStepsWorthSkipping = 100'000;
  const std::int64_t period = repetition.period_steps;
  const std::int64_t begin = repetition.from_step + 2 * period;
  const std::int64_t start = begin + (steps_ - begin) % period;
  if (steps_ - start >= kStepsWorthSkipping + period) periods_ = Periods{start, period};
}

// If a period has no arc and no contact, but ends an arc that was too short to count, all later periods are
// the same.
void DriftMeter::judge_period(std::int64_t step) {
  if (step == periods_->start) periods_->before = summary();
  if (step != periods_->start + periods_->steps) return;
  const DriftSummary& before = periods_->before;
  const DriftSummary after = summary();
  const std::int64_t skipped = after.skipped_arcs - before.skipped_arcs;
  is_over_ = after.arcs == before.arcs && after.contacts == before.contacts && skipped > 0;
  if (is_over_) arcs_skipped_later_ = (steps_ - step) / periods_->steps * skipped;
  periods_.reset();
}

DriftSummary DriftMeter::summary() const {
  DriftSummary summary = meter_.summary();
  summary.skipped_arcs = cutter_.skipped_arcs() + arcs_skipped_later_;
  summary.non_finite_step = cutter_.non_finite_step();
  return summary;
}

DriftSummary DriftMeter::finish() {
  cutter_.finish();
  return summary();
}

}  // namespace hyrax

#include "sim/reference/drift_meter.h"

namespace hyrax {

void DriftMeter::row(const Row& row) {
  if (is_over_) return;
  const double floor_px = cutter_.playback().bounds().bottom_px;
  const bool is_before_input = cutter_.playback().has_inputs_after(row.step);
  cutter_.row(row);
  const bool was_open = resting_.open_from_step().has_value();
  resting_.row(row.step, last_.contact, row.contact, row.y_px, floor_px);
  if (!was_open) {
    open_from_s_ = row.t_s;
    has_gone_on_ = resting_.has_gone_on();
  }
  last_ = row;
  if (is_before_input)
    end_stretch(row.step);
  else if (!resting_.open_from_step() && meter_.has_contacts_to_settle())
    meter_.settle(row.step, std::nullopt);
  if (periods_) judge_period(row.step);
}

void DriftMeter::end_stretch(std::int64_t step) {
  resting_.end(step);
  meter_.settle(step, resting_.from_step());
  if (!resting_.from_step()) return;
  if (has_gone_on_ && !rests_.empty())
    rests_.back().to_s = last_.t_s;
  else if (rests_.size() < DriftSummary::kRestsMax)
    rests_.push_back({open_from_s_, last_.t_s});
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
  end_stretch(is_over_ ? steps_ : last_.step);
  DriftSummary result = summary();
  result.rests = rests_;
  result.is_resting_at_end = resting_.from_step().has_value();
  return result;
}

}  // namespace hyrax

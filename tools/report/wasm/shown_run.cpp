#include "tools/report/wasm/shown_run.h"

#include <algorithm>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

bool is_same_row(const Row& a, const Row& b) {
  return same_bits(state_of(a), state_of(b)) && same_bits(a.t_s, b.t_s) && same_bits(a.dt_s, b.dt_s) &&
         a.contact == b.contact;
}

std::int64_t first_step_of_block(std::size_t block) { return static_cast<std::int64_t>(block * kBlockRows); }

}  // namespace

void ShownRows::rows(const Columns& batch) {
  for (std::size_t index = 0; index < batch.size(); ++index) columns_.append(batch.row(index));
}

void ShownRows::contact_began(const Contact& contact) {
  if (contacts_.size() < kContactsShownMax) contacts_.push_back(contact);
}

void ShownRows::contact_ended(std::int64_t index, std::int64_t last_step) {
  if (static_cast<std::size_t>(index) < contacts_.size())
    contacts_[static_cast<std::size_t>(index)].last_step = last_step;
}

RowSink::Wants EvidenceCheck::wants() const {
  return {.rows_every = next_row_ < evidence_.rows.size() ? 1 : 0, .blocks = !evidence_.blocks.empty()};
}

void EvidenceCheck::rows(const Columns& batch) {
  for (std::size_t index = 0; index < batch.size() && next_row_ < evidence_.rows.size(); ++index) {
    const Row kept = evidence_.rows.row(next_row_);
    if (batch.step[index] < kept.step) continue;
    if (!row_ && (batch.step[index] != kept.step || !is_same_row(kept, batch.row(index)))) row_ = kept.step;
    ++next_row_;
  }
}

void EvidenceCheck::block(const Block& block, std::int64_t count) {
  for (; count > 0 && next_block_ < evidence_.blocks.size(); --count, ++next_block_)
    if (!block_ && evidence_.blocks[next_block_] != block.digest) block_ = first_step_of_block(next_block_);
}

std::optional<std::int64_t> EvidenceCheck::first_difference() const {
  if (!row_ || !block_) return row_ ? row_ : block_;
  // A row of the block that differs says more than the block.
  const bool is_in_block = *row_ >= *block_ && *row_ < *block_ + static_cast<std::int64_t>(kBlockRows);
  return is_in_block ? *row_ : std::min(*row_, *block_);
}

ShownRun::ShownRun(const Core& core, const Scenario& scenario, FileEvidence evidence)
    : scenario_(scenario),
      shown_(step_count(scenario_)),
      check_(std::move(evidence)),
      replay_(core, scenario_, sinks()) {}

std::vector<RowSink*> ShownRun::sinks() {
  std::vector<RowSink*> sinks = {&shown_, &check_};
  const std::int64_t steps = step_count(scenario_);
  if (steps <= kStepsMeasuredMax)
    sinks.push_back(&meter_.emplace(scenario_, inputs_of(scenario_, steps), drift_));
  return sinks;
}

std::int64_t ShownRun::play_to(std::int64_t step) {
  replay_.play_to(std::min(step, steps()));
  return replay_.keyframe().row.step;
}

void ShownRun::finish() {
  summary_ = replay_.finish();
  if (meter_) errors_ = meter_->finish();
}

}  // namespace hyrax

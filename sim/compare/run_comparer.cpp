#include "sim/compare/run_comparer.h"

#include <algorithm>

#include "sim/compare/trajectory_comparer.h"
#include "sim/trajectory/block_rows.h"

namespace hyrax {

std::optional<Divergence> first_difference(const Row& expected, const Row& actual) {
  for (const RowField& field : kRowFields) {
    const double a = field.value(expected);
    const double b = field.value(actual);
    if (!agrees(a, b)) return divergence_at(actual.step, field.name, a, b);
  }
  return std::nullopt;
}

void RunComparer::rows(const Columns& batch) {
  const auto first = static_cast<std::size_t>(rows_seen_);
  rows_seen_ += static_cast<std::int64_t>(batch.size());
  for (std::size_t index = 0; index < batch.size() && first + index < kept_.rows.size(); ++index) {
    const Row expected = kept_.rows.row(first + index);
    const Row actual = batch.row(index);
    if (same_bits(expected, actual)) continue;
    distance_.add(expected, actual);
    if (result_.first) continue;
    result_.first = first_difference(expected, actual);
    if (result_.first) look_around(batch, index);
  }
}

void RunComparer::look_around(const Columns& batch, std::size_t index) {
  constexpr std::size_t kRowsAround = 2;
  const std::size_t first = index < kRowsAround ? 0 : index - kRowsAround;
  for (std::size_t at = first; at < std::min(batch.size(), index + kRowsAround + 1); ++at) {
    const auto kept = static_cast<std::size_t>(batch.step[at]);
    result_.actual_around.push_back(batch.row(at));
    if (kept < kept_.rows.size()) result_.expected_around.push_back(kept_.rows.row(kept));
  }
}

void RunComparer::block(const Block& block, std::int64_t count) {
  for (std::int64_t passed = 0; passed < count && kept_block_ < kept_.blocks.size();) {
    const StoredBlock& kept = kept_.blocks[kept_block_];
    compare({kept, kept_block_used_, block, passed});
    const std::int64_t used = std::min(count - passed, kept.count - kept_block_used_);
    passed += used;
    kept_block_used_ += used;
    if (kept_block_used_ == kept.count) {
      ++kept_block_;
      kept_block_used_ = 0;
    }
  }
}

void RunComparer::compare(const BlockPair& pair) {
  const bool is_same_block = pair.kept.digest == pair.played.digest;
  if (is_same_block && !result_.first && pair.kept_repetition == 0) check_upkeep(pair.kept, pair.played);
  if (!is_same_block && !result_.first) find_row(pair);
  if (!is_same_block) measure(pair);
}

std::int64_t RunComparer::BlockPair::first_step() const {
  return kept.keyframe.row.step + kept_repetition * static_cast<std::int64_t>(kBlockRows);
}

// Where the digests agree, all that is kept beside them must agree as well.
void RunComparer::check_upkeep(const StoredBlock& kept, const Block& block) {
  if (!is_same_keyframe(kept.keyframe, block.keyframe)) damage_ = "keyframes";
  for (std::size_t index = 0; index < kept.checks.size(); ++index)
    if (index >= block.rows.size() || check_of(block.rows.row(index)) != kept.checks[index])
      damage_ = "row checks";
}

const RowBlock& RunComparer::expanded(const StoredBlock& kept) {
  if (expanded_block_ == kept_block_) return expanded_;
  expanded_block_ = kept_block_;
  expanded_ = expand_(kept);
  if (digest(expanded_) != kept.digest) expanded_.shrink(0);
  return expanded_;
}

void RunComparer::find_row(const BlockPair& pair) {
  const RowBlock& expected = expanded(pair.kept);
  if (find_row_in(expected, pair)) return;
  if (expected.size() > 0) return;  // One of them has more rows.
  if (find_row_by_checks(pair)) return;
  result_.first = Divergence{pair.first_step(), "state", std::nullopt, std::nullopt, std::nullopt};
}

bool RunComparer::find_row_in(const RowBlock& expected, const BlockPair& pair) {
  const RowBlock& actual = pair.played.rows;
  const auto row_of = [&](const RowBlock& rows, std::size_t index) {
    Row row = rows.row(index);
    row.step = pair.first_step() + static_cast<std::int64_t>(index);
    return row;
  };
  for (std::size_t index = 0; index < std::min(expected.size(), actual.size()); ++index) {
    result_.first = first_difference(row_of(expected, index), row_of(actual, index));
    if (result_.first) return true;
  }
  return false;
}

bool RunComparer::find_row_by_checks(const BlockPair& pair) {
  constexpr std::size_t kFirstField = 1;  // Checks have no t; else they are in the fields' order.
  const std::vector<RowCheck>& checks = pair.kept.checks;
  for (std::size_t index = 0; index < std::min(checks.size(), pair.played.rows.size()); ++index) {
    Row actual = pair.played.rows.row(index);
    actual.step = pair.first_step() + static_cast<std::int64_t>(index);
    const RowCheck check = check_of(actual);
    const auto differing = std::mismatch(check.begin(), check.end(), checks[index].begin()).first;
    if (differing == check.end()) continue;
    const RowField& field = kRowFields[kFirstField + static_cast<std::size_t>(differing - check.begin())];
    result_.first = index == 0 ? divergence_at(actual.step, field.name, field.value(pair.kept.keyframe.row),
                                               field.value(actual))
                               : Divergence{actual.step, std::string(field.name), std::nullopt,
                                            field.value(actual), std::nullopt};
    return true;
  }
  return false;
}

// Of rows that are not known, the first one is kept all the same.
void RunComparer::measure(const BlockPair& pair) {
  const RowBlock& expected = expanded(pair.kept);
  BlockRows kept(pair.kept.keyframe, expected, pair.kept_repetition);
  BlockRows played(pair.played.keyframe, pair.played.rows, pair.played_repetition);
  if (expected.size() == 0) {
    distance_.add(kept.first(), played.first());
    distance_.add_unknown();
    result_.has_unknown_rows = true;
    return;
  }
  for (std::size_t index = 0; index < std::min(expected.size(), pair.played.rows.size()); ++index)
    distance_.add(kept.next(), played.next());
}

std::string RunComparer::contradiction(const Played& played) const {
  if (!damage_.empty()) return damage_;
  if (kept_.state_hash != played.state_hash) return "state hash";
  if (input_difference(kept_.inputs, played.inputs)) return "events";
  if (first_difference(kept_.final, played.final)) return "last row";
  const auto recorded = static_cast<std::int64_t>(contacts_.size());
  if (recorded < kContactsRecordedMax && kept_.contacts_total != recorded) return "number of contacts";
  return "";
}

std::string RunComparer::difference_in_shape(const Played& played) const {
  if (!plays_the_same(kept_.scenario, played.scenario)) return "the scenario changed since it was blessed";
  if (kept_.steps != played.steps)
    return "the golden file has " + std::to_string(kept_.steps) + " steps, the run has " +
           std::to_string(played.steps);
  if (result_.first || !result_.contacts.is_none()) return "";
  const std::string damage = contradiction(played);
  if (!damage.empty())
    return "the golden file contradicts itself (" + damage +
           "): its rows agree with the run; it was changed after blessing";
  return "";
}

// Rows and blocks of equal bits were not searched for a NaN, with which a run ends.
void RunComparer::compare_ends(const Played& played) {
  if (kept_.final.step == played.final.step && (result_.first || !is_finite(state_of(played.final))))
    distance_.add(kept_.final, played.final);
  if (!result_.first && !is_finite(state_of(played.final)))
    result_.first = first_difference(kept_.final, played.final);
}

Comparison RunComparer::finish(const Played& played) {
  result_.contacts = contact_changes(kept_.contacts, contacts_);
  compare_ends(played);
  if (!result_.first && result_.contacts.is_none()) {
    result_.first = first_difference(kept_.contacts, contacts_);
    for (std::size_t index = 0; index < contacts_.size(); ++index)
      distance_.add(kept_.contacts[index], contacts_[index]);
  }
  result_.largest = distance_.largest();
  result_.shape = difference_in_shape(played);
  if (kept_.physics != played.physics)
    result_.physics = "the golden file is of physics model '" + kept_.physics + "', this program is of '" +
                      std::string(played.physics) + "'";
  if (!result_.shape.empty())
    result_.difference = DifferenceClass::shape;
  else if (result_.first || !result_.contacts.is_none())
    result_.difference = class_of(result_.contacts, distance_);
  result_.agrees = !result_.difference.has_value();
  return std::move(result_);
}

}  // namespace hyrax

#include "sim/compare/run_comparer.h"

#include <algorithm>

#include "sim/compare/trajectory_comparer.h"

namespace hyrax {

std::optional<Divergence> first_difference(const Row& expected, const Row& actual) {
  for (const RowField& field : kRowFields) {
    const double a = field.value(expected);
    const double b = field.value(actual);
    if (!agrees(a, b)) return Divergence{actual.step, std::string(field.name), a, b};
  }
  return std::nullopt;
}

void RunComparer::row(const Row& actual) {
  constexpr std::int64_t kRowsAround = 2;
  std::vector<Row>& around = result_.actual_around;
  if (!result_.first || actual.step <= result_.first->step + kRowsAround) around.push_back(actual);
  if (!result_.first && std::ssize(around) > kRowsAround + 1) around.erase(around.begin());
  if (actual.step >= std::ssize(kept_.rows.step)) return;
  const Row expected = kept_.rows.row(static_cast<std::size_t>(actual.step));
  if (same_bits(expected, actual)) return;
  distance_.add(expected, actual);
  if (!result_.first) result_.first = first_difference(expected, actual);
}

void RunComparer::block(const Block& block, std::int64_t count) {
  for (std::int64_t passed = 0; passed < count && kept_block_ < kept_.blocks.size();) {
    const StoredBlock& kept = kept_.blocks[kept_block_];
    if (kept.digest != block.digest)
      compare(kept, block, passed);
    else if (!result_.first && kept_block_used_ == 0)
      check_upkeep(kept, block);
    const std::int64_t used = std::min(count - passed, kept.count - kept_block_used_);
    passed += used;
    kept_block_used_ += used;
    if (kept_block_used_ == kept.count) {
      ++kept_block_;
      kept_block_used_ = 0;
    }
  }
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

// The blocks' times are not compared: digests do not cover them. Of rows that are not known, the first one is
// kept all the same.
void RunComparer::compare(const StoredBlock& kept, const Block& played, std::int64_t played_repetition) {
  const RowBlock& expected = expanded(kept);
  BlockRows kept_rows(kept.keyframe, expected, kept_block_used_);
  BlockRows played_rows(played.keyframe, played.rows, played_repetition);
  if (expected.size() == 0) {
    if (!result_.first) result_.first = find_by_checks(kept, kept_rows.first().step, played.rows);
    distance_.add(kept_rows.first(), played_rows.first());
    distance_.add_unknown();
    result_.distance.has_unknown_rows = true;
  }
  for (std::size_t index = 0; index < std::min(expected.size(), played.rows.size()); ++index) {
    Row a = kept_rows.next();
    Row b = played_rows.next();
    distance_.add(a, b);
    a.t_s = b.t_s = 0.0;
    if (!result_.first) result_.first = first_difference(a, b);
  }
}

Divergence RunComparer::find_by_checks(const StoredBlock& kept, std::int64_t first_step,
                                       const RowBlock& played) {
  constexpr std::size_t kFirstField = 1;  // Checks have no t; else they are in the fields' order.
  for (std::size_t index = 0; index < std::min(kept.checks.size(), played.size()); ++index) {
    const Row actual = played.row(index);
    const RowCheck check = check_of(actual);
    const auto differing = std::ranges::mismatch(check, kept.checks[index]).in1;
    if (differing == check.end()) continue;
    const RowField& field = kRowFields[kFirstField + static_cast<std::size_t>(differing - check.begin())];
    Divergence found{
        first_step + static_cast<std::int64_t>(index), std::string(field.name), {}, field.value(actual)};
    if (index == 0) found.expected = field.value(kept.keyframe.row);
    return found;
  }
  return {first_step, "state", {}, {}};
}

std::string RunComparer::contradiction(const Scenario& scenario, const RunSummary& summary) const {
  if (!damage_.empty()) return damage_;
  if (kept_.state_hash != hex(summary.state_hash)) return "state hash";
  if (input_difference(kept_.inputs, inputs_of(scenario, summary.steps))) return "events";
  if (first_difference(kept_.final, summary.final)) return "last row";
  const auto recorded = static_cast<std::int64_t>(contacts().size());
  if (recorded < kContactsRecordedMax && kept_.contacts_total != recorded) return "number of contacts";
  return "";
}

std::string RunComparer::difference_in_shape(const Scenario& scenario, const RunSummary& summary) const {
  if (!plays_the_same(kept_.scenario, scenario)) return "the scenario changed since it was blessed";
  if (kept_.steps != summary.steps)
    return "the golden file has " + std::to_string(kept_.steps) + " steps, the run has " +
           std::to_string(summary.steps);
  if (result_.first || !result_.contacts.is_none()) return "";
  if (const std::string damage = contradiction(scenario, summary); !damage.empty())
    return "the golden file contradicts itself (" + damage +
           "): its rows agree with the run; it was changed after blessing";
  return "";
}

// Rows and blocks of equal bits were not searched for a NaN, with which a run ends.
void RunComparer::compare_ends(const Row& final) {
  const bool is_non_finite = !is_finite(state_of(final));
  if (kept_.final.step == final.step && (result_.first || is_non_finite)) distance_.add(kept_.final, final);
  if (!result_.first && is_non_finite) result_.first = first_difference(kept_.final, final);
}

Comparison RunComparer::finish(const Scenario& scenario, std::string_view physics,
                               const RunSummary& summary) {
  if (!result_.first) result_.actual_around.clear();
  for (const Row& row : result_.actual_around)
    if (row.step < std::ssize(kept_.rows.step))
      result_.expected_around.push_back(kept_.rows.row(static_cast<std::size_t>(row.step)));
  const auto of_one_source = [&](std::vector<Contact> contacts) {
    std::erase_if(contacts,
                  [&](const Contact& each) { return (static_cast<int>(each.wall) & other_walls_) != 0; });
    return contacts;
  };
  result_.contacts = contact_changes(of_one_source(kept_.contacts), of_one_source(contacts()));
  result_.contacts.is_cut |= other_walls_ != 0;
  compare_ends(summary.final);
  if (!result_.first && result_.contacts.is_none() && other_walls_ == 0) {
    result_.first = first_difference(kept_.contacts, contacts());
    for (std::size_t index = 0; index < contacts().size(); ++index)
      distance_.add(kept_.contacts[index], contacts()[index]);
  }
  result_.distance.largest = distance_.largest();
  result_.distance.is_at_equal_times = distance_.has_other_dt();
  result_.expected_end = {.row = kept_.final, .is_rest_known = false};
  result_.actual_end = {.row = summary.final, .settled_since_s = summary.at_rest_since_s};
  result_.shape = difference_in_shape(scenario, summary);
  if (kept_.physics != physics)
    result_.physics = "the golden file is of physics model '" + kept_.physics + "', this program is of '" +
                      std::string(physics) + "'";
  if (!result_.shape.empty())
    result_.difference = DifferenceClass::shape;
  else if (result_.first || !result_.contacts.is_none())
    result_.difference = class_of(result_.contacts, distance_);
  result_.agrees = !result_.difference.has_value();
  return std::move(result_);
}

}  // namespace hyrax

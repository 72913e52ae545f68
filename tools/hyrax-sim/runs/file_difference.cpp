#include "tools/hyrax-sim/runs/file_difference.h"

#include <fmt/format.h>

#include <algorithm>

namespace hyrax {
namespace {

// The rows of a file, one after another, in batches.
class RowCursor {
 public:
  explicit RowCursor(const TrajectoryFile& file) : file_(file) { load(0); }
  [[nodiscard]] bool is_done() const { return at_ >= batch_.size(); }
  [[nodiscard]] Row row() const { return batch_.row(at_); }
  void next() {
    if (++at_ == batch_.size()) load(first_ + static_cast<std::int64_t>(batch_.size()));
  }

 private:
  static constexpr std::int64_t kBatch = 65536;
  void load(std::int64_t first) {
    first_ = first;
    at_ = 0;
    batch_ = file_.rows(first, std::min(kBatch, file_.row_count() - first));
  }

  const TrajectoryFile& file_;
  Columns batch_;
  std::int64_t first_ = 0;
  std::size_t at_ = 0;
};

// Compares rows of the same step; a step that one file does not record is skipped.
void compare_rows(const TrajectoryFile& a, const TrajectoryFile& b, FileDifference& difference) {
  RowCursor left(a);
  RowCursor right(b);
  while (!left.is_done() && !right.is_done()) {
    const Row row_a = left.row();
    const Row row_b = right.row();
    if (row_a.step == row_b.step) {
      difference.values.compare(row_a, row_b);
      ++difference.rows_compared;
    }
    if (row_a.step != row_b.step && !difference.lone_step)
      difference.lone_step = std::min(row_a.step, row_b.step);
    if (row_a.step <= row_b.step) left.next();
    if (row_b.step <= row_a.step) right.next();
  }
  if (difference.lone_step) return;
  if (!left.is_done()) difference.lone_step = left.row().step;
  if (!right.is_done()) difference.lone_step = right.row().step;
}

// Golden files of long runs hold the first row of each block, other files the rows that the scenario records.
bool hold_recorded_rows(const TrajectoryFile& a, const TrajectoryFile& b) {
  return !a.has("blocks") && !b.has("blocks");
}

std::string shape_of(const FileHead& a, const FileHead& b) {
  if (a.steps != b.steps) return fmt::format("the numbers of steps differ: {} and {}", a.steps, b.steps);
  if (!plays_the_same(a.scenario, b.scenario)) return "the scenarios differ";
  return "";
}

}  // namespace

FileDifference compare_files(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance) {
  FileDifference difference{{}, TrajectoryComparer(tolerance), 0, {}};
  Comparison& comparison = difference.comparison;
  compare_rows(a, b, difference);
  difference.values.compare(a.contacts(), b.contacts());
  comparison.first = difference.values.first();
  comparison.contacts = difference.values.contacts();
  comparison.largest = difference.values.distance().largest();
  comparison.shape = shape_of(a.head(), b.head());
  if (a.head().physics != b.head().physics)
    comparison.physics = "the physics models differ: " + a.head().physics + " and " + b.head().physics;
  if (comparison.shape.empty() && difference.lone_step && hold_recorded_rows(a, b))
    comparison.shape = fmt::format("only one of the files holds row {}", *difference.lone_step);
  if (!comparison.shape.empty())
    comparison.difference = DifferenceClass::shape;
  else if (a.contacts_total() != b.contacts_total())
    comparison.difference = DifferenceClass::contacts;
  else if (comparison.first || !comparison.contacts.is_none() ||
           (tolerance.is_exact() && a.head().state_hash != b.head().state_hash))
    comparison.difference = class_of(comparison.contacts, difference.values.distance());
  comparison.agrees = !comparison.difference;
  return difference;
}

}  // namespace hyrax

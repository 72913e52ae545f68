#include "tools/app/diff/trajectory_diff.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/trajectory/run_summary.h"
#include "tools/files/scenario_changes.h"

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

// Rows of the same step; a step that one file does not record is skipped. Returns the first of these.
template <class Visit>
std::optional<std::int64_t> walk_by_step(const TrajectoryFile& a, const TrajectoryFile& b,
                                         const Visit& visit) {
  std::optional<std::int64_t> lone_step;
  RowCursor left(a);
  RowCursor right(b);
  while (!left.is_done() && !right.is_done()) {
    const Row row_a = left.row();
    const Row row_b = right.row();
    if (row_a.step == row_b.step) visit(row_a, row_b);
    if (row_a.step != row_b.step && !lone_step) lone_step = std::min(row_a.step, row_b.step);
    if (row_a.step <= row_b.step) left.next();
    if (row_b.step <= row_a.step) right.next();
  }
  if (!lone_step && !left.is_done()) lone_step = left.row().step;
  if (!lone_step && !right.is_done()) lone_step = right.row().step;
  return lone_step;
}

// What both runs show at every time at which one of them changes, to the end of the shorter one. Rows less
// than half the shorter of their frames apart are of the same time: sums of other frames round, and clocks
// are slightly off.
template <class Visit>
void walk_by_time(const TrajectoryFile& a, const TrajectoryFile& b, const Visit& visit) {
  RowCursor left(a);
  RowCursor right(b);
  Row row_a = left.row();
  Row row_b = right.row();
  while (!left.is_done() && !right.is_done()) {
    const Row next_a = left.row();
    const Row next_b = right.row();
    const double same_s = std::max(0.0, 0.5 * std::min(next_a.dt_s, next_b.dt_s));
    // A time that is not a number is not later than any.
    if (!(next_a.t_s > next_b.t_s + same_s)) {
      row_a = next_a;
      left.next();
    }
    if (!(next_b.t_s > next_a.t_s + same_s)) {
      row_b = next_b;
      right.next();
    }
    visit(row_a, row_b);
  }
}

RunEnd end_of(const TrajectoryFile& file) {
  RunEnd end;
  end.has_every_row = file.row_count() == file.head().steps + 1;
  std::optional<RestAnchor> anchor;
  for (RowCursor cursor(file); !cursor.is_done(); cursor.next()) {
    end.row = cursor.row();
    if (!anchor)
      anchor = {end.row.x_px, end.row.y_px, end.row.t_s};
    else if (anchor->moves_to(end.row.x_px, end.row.y_px))
      anchor->t_s = end.row.t_s;
  }
  end.contacts_total = file.contacts_total();
  if (end.has_every_row) end.settled_since_s = anchor->at_rest_since_s(end.row.t_s);
  return end;
}

// Golden files of long runs hold the first row of each block, other files the rows that the scenario records.
bool hold_recorded_rows(const TrajectoryFile& a, const TrajectoryFile& b) {
  return !a.has("blocks") && !b.has("blocks");
}

// Why a file must be damaged, as a sentence: all rows and contacts are recorded and agree, but the state
// hashes or the numbers of contacts do not. Else empty.
std::string contradiction(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance,
                          const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  if (comparison.first || !comparison.contacts.is_none()) return "";
  if (diff.end_a.contacts_total != diff.end_b.contacts_total && !comparison.contacts.is_cut)
    return "a file contradicts itself: the contacts agree, their numbers do not";
  if (tolerance.is_exact() && a.head().state_hash != b.head().state_hash &&
      diff.rows_compared == a.head().steps + 1)
    return "a file contradicts itself: all rows agree, the state hashes do not";
  return "";
}

std::string shape_of(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance,
                     const TrajectoryDiff& diff, const std::optional<std::int64_t>& lone_step) {
  const std::string changes = scenario_changes(a.head().scenario, b.head().scenario);
  if (!changes.empty()) return "the scenarios differ: " + changes;
  if (a.head().steps != b.head().steps)
    return fmt::format("the numbers of steps differ: {} and {}", a.head().steps, b.head().steps);
  if (lone_step && hold_recorded_rows(a, b))
    return fmt::format("only one of the files holds row {}", *lone_step);
  if (const auto difference = input_difference(a.inputs(), b.inputs())) return "the " + *difference;
  return contradiction(a, b, tolerance, diff);
}

std::optional<DifferenceClass> class_of_files(const TrajectoryFile& a, const TrajectoryFile& b,
                                              const Tolerance& tolerance, const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  if (!comparison.shape.empty()) return DifferenceClass::shape;
  if (diff.end_a.contacts_total != diff.end_b.contacts_total) return DifferenceClass::contacts;
  if (comparison.first || !comparison.contacts.is_none() ||
      (tolerance.is_exact() && a.head().state_hash != b.head().state_hash))
    return class_of(comparison.contacts, diff.values.distance());
  return std::nullopt;
}

}  // namespace

bool TrajectoryDiff::has_differences() const {
  return !comparison.agrees || !comparison.physics.empty() ||
         std::ranges::any_of(values.worst(), [](const auto& worst) { return worst.has_value(); });
}

TrajectoryDiff diff_trajectories(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance,
                                 Overlay* overlay) {
  TrajectoryDiff diff(tolerance);
  if (a.head().constants && b.head().constants) diff.energy.emplace(a.head().constants->gravity_px_per_s2);
  diff.is_by_time = !(a.head().scenario.clock == b.head().scenario.clock);
  Comparison& comparison = diff.comparison;
  RunDistance distance;
  const auto measure = [&](const Row& row_a, const Row& row_b) {
    Row of_same_step = row_b;
    of_same_step.step = row_a.step;
    const std::optional<WorstDistance> before = distance.largest();
    distance.add(row_a, of_same_step);
    if (distance.largest() && (!before || distance.largest()->px > before->px)) diff.largest_at_s = row_a.t_s;
    if (diff.energy) diff.energy->add(row_a, row_b);
    if (overlay != nullptr) overlay->add(row_a, row_b);
  };
  const auto lone_step = walk_by_step(a, b, [&](const Row& row_a, const Row& row_b) {
    diff.values.compare(row_a, row_b);
    ++diff.rows_compared;
    if (!diff.is_by_time) measure(row_a, row_b);
  });
  if (diff.is_by_time) walk_by_time(a, b, measure);
  diff.values.compare(a.contacts(), b.contacts());
  comparison.first = diff.values.first();
  comparison.contacts = diff.values.contacts();
  comparison.largest = distance.largest();
  diff.end_a = end_of(a);
  diff.end_b = end_of(b);
  comparison.shape = shape_of(a, b, tolerance, diff, lone_step);
  if (a.head().physics != b.head().physics)
    comparison.physics = "the physics models differ: " + a.head().physics + " and " + b.head().physics;
  comparison.difference = class_of_files(a, b, tolerance, diff);
  comparison.agrees = !comparison.difference;
  if (diff.end_a.settled_since_s && diff.end_b.settled_since_s)
    comparison.rest_shift_px = distance_px(state_of(diff.end_a.row), state_of(diff.end_b.row));
  return diff;
}

}  // namespace hyrax

// Two runs at equal times, whatever their clocks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "sim/compare/run_distance.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// Puts the next rows of a run, in order of steps, in place of those in the batch; none: it has ended. A
/// batch has functions size() and row(index), whose rows have a step and t_s.
template <class Batch>
using BatchesOf = std::function<void(Batch& batch)>;
using RowBatches = BatchesOf<Columns>;

/// Those of a run that is held whole.
template <class Batch>
[[nodiscard]] BatchesOf<Batch> batches_of(const Batch& rows) {
  return [rows = rows](Batch& batch) mutable { batch = std::exchange(rows, {}); };
}

/// Reads them one after another.
template <class Batch>
class CursorOf {
 public:
  explicit CursorOf(BatchesOf<Batch> batches) : batches_(std::move(batches)) { batches_(batch_); }
  [[nodiscard]] bool is_done() const { return at_ >= batch_.size(); }
  /// REQUIRES: not is_done(), as of next().
  [[nodiscard]] auto row() const { return batch_.row(at_); }
  void next() {
    if (++at_ < batch_.size()) return;
    batches_(batch_);
    at_ = 0;
  }

 private:
  BatchesOf<Batch> batches_;
  Batch batch_;
  std::size_t at_ = 0;
};
using RowCursor = CursorOf<Columns>;

/// Calls visit(row of a, row of b) for rows of the same step; a step that only one has is skipped. Returns
/// the first of these.
template <class Batch>
std::optional<std::int64_t> walk_by_step(CursorOf<Batch> a, CursorOf<Batch> b, const auto& visit) {
  std::optional<std::int64_t> lone_step;
  while (!a.is_done() && !b.is_done()) {
    const auto row_a = a.row(), row_b = b.row();
    if (row_a.step == row_b.step) visit(row_a, row_b);
    if (row_a.step != row_b.step && !lone_step) lone_step = std::min(row_a.step, row_b.step);
    if (row_a.step <= row_b.step) a.next();
    if (row_b.step <= row_a.step) b.next();
  }
  if (!lone_step && !a.is_done()) lone_step = a.row().step;
  if (!lone_step && !b.is_done()) lone_step = b.row().step;
  return lone_step;
}

/// A run that time passes in. Between two rows it is on the straight line between them; at a time of several
/// rows it is at the last of them, and the line before ends at the first.
template <class Batch>
class TimeWalk {
 public:
  using Row = decltype(std::declval<const Batch&>().row(0));

  /// @param jumps frames of which no straight line shows the way, in order: of frame i the times after row i
  /// up to row i + 2 are left out.
  TimeWalk(BatchesOf<Batch> rows, std::vector<std::int64_t> jumps)
      : rows_(std::move(rows)), jumps_(std::move(jumps)) {}

  [[nodiscard]] bool is_at_end() const { return rows_.is_done(); }
  /// REQUIRES: not is_at_end(), as of pass_to.
  [[nodiscard]] double next_t_s() const { return rows_.row().t_s; }

  /// The run at that time, which is not after that of its next row; nothing before its first row, or where it
  /// is left out.
  /// @param between the run between two rows, at a time, of which it may have nothing.
  std::optional<Row> pass_to(double t_s, const auto& between) {
    const std::int64_t passed = last_ ? last_->step : -1;
    const Row next = rows_.row();
    const auto jump = std::ranges::lower_bound(jumps_, passed - 1);
    const bool is_left_out = jump != jumps_.end() && *jump < next.step;
    if (is_left_out) left_out_.insert(*jump);
    std::optional<Row> row;
    if (next.t_s > t_s) {
      if (last_) row = between(*last_, next, t_s);
    } else {
      do {
        last_ = rows_.row();
        rows_.next();
      } while (!rows_.is_done() && rows_.row().t_s <= t_s);
      row = last_;
    }
    return is_left_out ? std::nullopt : row;
  }

  [[nodiscard]] const std::set<std::int64_t>& left_out() const { return left_out_; }

 private:
  CursorOf<Batch> rows_;
  std::optional<Row> last_ = {};          // Up to the present time.
  std::vector<std::int64_t> jumps_;       // Their frames,
  std::set<std::int64_t> left_out_ = {};  // and those that were left out.
};

/// Calls visit(row of a, row of b, time) with both runs at the row times of either, up to the earlier end.
/// Returns how many frames were left out.
template <class Batch>
std::int64_t walk_times(TimeWalk<Batch> a, TimeWalk<Batch> b, const auto& between, const auto& visit) {
  while (!a.is_at_end() && !b.is_at_end()) {
    const double t_s = a.next_t_s() > b.next_t_s() ? b.next_t_s() : a.next_t_s();
    const auto row_a = a.pass_to(t_s, between), row_b = b.pass_to(t_s, between);
    if (row_a && row_b) visit(*row_a, *row_b, t_s);
  }
  std::set<std::int64_t> left_out = a.left_out();
  left_out.insert(b.left_out().begin(), b.left_out().end());
  return std::ssize(left_out);
}

/// A run that is walked through: its rows, from row 0, and its inputs in order of frames.
struct TimedRun {
  RowBatches rows;
  std::vector<Input> inputs;
};

using PairVisit = std::function<void(const Row& a, const Row& b)>;

/// Calls `visit` as walk_times; both rows have the time, and each the step of its run's last row up to it.
/// What is left out: a place, grab, release or resize in a frame of either. Returns the distance.
[[nodiscard]] Distance walk_equal_times(
    const TimedRun& a, const TimedRun& b, const PairVisit& visit = [](const Row&, const Row&) {});

}  // namespace hyrax

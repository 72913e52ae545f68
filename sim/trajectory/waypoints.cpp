#include "sim/trajectory/waypoints.h"

#include <cassert>

#include "sim/trajectory/stored_run.h"

namespace hyrax {

RowSink::Wants WaypointMeter::wants() const {
  if (is_stored_as_rows(steps_)) return {.rows_every = 1};
  return {.blocks = true};
}

void WaypointMeter::block(const Block& block, std::int64_t count) {
  BlockRows rows(block.keyframe, block.rows);
  for (std::size_t index = 0; index < block.rows.size(); ++index) row(rows.next());
  if (count > 1 && !has_all_seconds()) add_repetitions(block, count);
}

void WaypointMeter::row(const Row& row) {
  if (!last_ || row.y_px < found_.apex.y_px) found_.apex = row;
  while (last_ && !has_all_seconds() && is_past_next_second(row.t_s, row.dt_s))
    found_.at_seconds.push_back(*last_);
  last_ = row;
}

// All frames have one dt, so that the row at a second is found without a walk.
void WaypointMeter::add_repetitions(const Block& block, std::int64_t count) {
  constexpr auto kBlock = static_cast<std::int64_t>(kBlockRows);
  const auto row_at = [&](std::int64_t index) {
    Row row = block.rows.row(static_cast<std::size_t>(index % kBlock));
    row.step = block.keyframe.row.step + index;
    row.t_s = block.keyframe.timeline.time_s(index);
    return row;
  };
  std::int64_t at = kBlock;
  while (!has_all_seconds()) {
    std::int64_t past = count * kBlock;
    while (at < past) {
      const std::int64_t middle = at + (past - at) / 2;
      const Row row = row_at(middle);
      if (is_past_next_second(row.t_s, row.dt_s))
        past = middle;
      else
        at = middle + 1;
    }
    if (at == count * kBlock) break;
    found_.at_seconds.push_back(row_at(at - 1));
  }
  last_ = row_at(count * kBlock - 1);
}

Waypoints WaypointMeter::take() {
  assert(last_);
  const auto is_reached = [&] {
    return last_->t_s >= static_cast<double>(found_.at_seconds.size() + 1) - 1e-9 * last_->dt_s;
  };
  while (!has_all_seconds() && is_reached()) found_.at_seconds.push_back(*last_);
  return std::move(found_);
}

}  // namespace hyrax

// The rows of a block with their steps and times, which a block does not hold.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// Reads a block row by row. Refers to the rows. A block that repeats has frames of one dt only.
class BlockRows {
 public:
  /// @param first the state at the first row of the first repetition; @param repetition from 0.
  BlockRows(const Keyframe& first, const RowBlock& rows, std::int64_t repetition = 0)
      : rows_(rows), first_(first.row), timeline_(first.timeline) {
    const std::int64_t rows_before = repetition * static_cast<std::int64_t>(kBlockRows);
    first_.step += rows_before;
    timeline_.frames += rows_before;
    first_.t_s = timeline_.time_s();
  }

  /// Known even where the block's rows are not.
  [[nodiscard]] const Row& first() const { return first_; }
  /// REQUIRES: called once for each row, at most.
  [[nodiscard]] Row next() {
    assert(index_ < rows_.size());
    Row row = rows_.row(index_);
    if (index_ > 0) timeline_.play(row.dt_s);
    row.t_s = timeline_.time_s();
    row.step = first_.step + static_cast<std::int64_t>(index_++);
    return row;
  }

 private:
  const RowBlock& rows_;
  Row first_;
  Timeline timeline_;
  std::size_t index_ = 0;
};

}  // namespace hyrax

// One digest of a row sequence, wherever it comes from.
#pragma once

#include "sim/trajectory/row.h"
#include "sim/trajectory/row_block.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// The state hash of the rows added, in order (sim/trajectory/state_hash.h).
class RowDigest {
 public:
  void add(const Row& row) {
    pack_row(block_.extend(1), row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s, row.contact);
    if (block_.room() == 0) close_block();
  }

  /// Of all rows; nothing may be added after.
  [[nodiscard]] Digest finish() {
    if (block_.size() > 0) close_block();
    return hash_.value();
  }

 private:
  void close_block() {
    hash_.add(digest(block_));
    block_.shrink(0);
  }

  RowBlock block_;
  StateHash hash_;
};

}  // namespace hyrax

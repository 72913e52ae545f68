// What receives a run as it is played.
#pragma once

#include <cstdint>

#include "sim/trajectory/columns.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// From row `from_step` to the end of a run the whole state repeats every `period_steps`.
struct Repetition {
  std::int64_t from_step = 0;
  std::int64_t period_steps = 0;
};

/// 4,096 consecutive rows (the last block may be shorter), with the state of the first.
struct Block {
  Digest digest{};
  Keyframe keyframe;  ///< At the block's first row.
  const RowBlock& rows;
};

/// Receives rows, contacts and blocks in order, those that it wants: a replay does not make what no sink
/// wants.
class RowSink {
 public:
  struct Wants {
    std::int64_t rows_every = 0;   ///< Rows 0, K, 2K, ... and the last one; 0: none.
    std::int64_t all_rows_to = 0;  ///< Where K > 0, every row up to this one, too.
    bool contacts = false;
    bool blocks = false;
  };

  RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  /// Called when a replay begins, and for rows again after every batch: a sink may want fewer from then on.
  [[nodiscard]] virtual Wants wants() const { return {}; }

  /// Wanted rows, in batches of any size.
  virtual void rows(const Columns& /*batch*/) {}
  /// A contact, at its first step; `last_step` is not known yet. At most kContactsRecordedMax.
  virtual void contact_began(const Contact& /*contact*/) {}
  /// Contact `index` (from 0, in order of contact_began) lasted to `last_step`. Called only for
  /// contacts of more than one step, and at the latest when the run ends.
  virtual void contact_ended(std::int64_t /*index*/, std::int64_t /*last_step*/) {}
  /// Called once, as soon as a replay finds that the run repeats itself to its end.
  virtual void repeats(const Repetition& /*repetition*/) {}
  /// A complete block, or `count` blocks that are equal except for step and time.
  virtual void block(const Block& /*block*/, std::int64_t /*count*/) {}
};

}  // namespace hyrax

// Who receives a run as it is played.
#pragma once

#include <cstdint>

#include "sim/trajectory/columns.h"
#include "sim/trajectory/contact.h"
#include "sim/trajectory/keyframe.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// 4,096 consecutive rows (the last block may be shorter), with the state of the first.
struct Block {
  Digest digest{};
  Keyframe keyframe;  ///< At the block's first row.
  const RowBlock& rows;
};

/// Receives rows, contacts and blocks in order; what it does not want, it leaves as it is. A
/// replay asks `wants` once and does not make what is not wanted.
class RowSink {
 public:
  struct Wants {
    std::int64_t rows_every = 0;  ///< Rows 0, K, 2K, ... and the last one; 0: none.
    bool contacts = false;
    bool blocks = false;
  };

  RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  [[nodiscard]] virtual Wants wants() const { return {}; }

  /// Wanted rows, in batches of any size.
  virtual void rows(const Columns& /*batch*/) {}
  /// A contact, at its first step; `last_step` is not known yet. At most kContactsRecordedMax.
  virtual void contact_began(const Contact& /*contact*/) {}
  /// Contact `index` (from 0, in order of contact_began) lasted to `last_step`. Told only of
  /// contacts of more than one step, and at the latest when the run ends.
  virtual void contact_ended(std::int64_t /*index*/, std::int64_t /*last_step*/) {}
  /// A whole block, or the same block `count` times over: equal digests, equal states but for
  /// step and time.
  virtual void block(const Block& /*block*/, std::int64_t /*count*/) {}
};

}  // namespace hyrax

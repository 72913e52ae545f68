// What receives a run as it is played.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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

/// Reads a block row by row, with steps and times, which a block does not hold. Refers to the rows. A block
/// that repeats has frames of one dt only.
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

  /// Called when a replay begins, and for rows again after every 4,096: a sink may want fewer from then on.
  [[nodiscard]] virtual Wants wants() const { return {}; }

  /// A wanted row.
  virtual void row(const Row& /*row*/) {}
  /// Rows that are kept, one after another.
  void rows(const Columns& kept) {
    for (std::size_t index = 0; index < kept.size(); ++index) row(kept.row(index));
  }
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

/// Keeps the contacts of a run.
class ContactRecorder : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.contacts = true}; }
  void contact_began(const Contact& contact) override { contacts_.push_back(contact); }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    contacts_[static_cast<std::size_t>(index)].last_step = last_step;
  }
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }

 protected:
  std::vector<Contact> take_contacts() { return std::move(contacts_); }

 private:
  std::vector<Contact> contacts_;
};

}  // namespace hyrax

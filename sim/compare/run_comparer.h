// A run, as it is played, against the one that is kept.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sim/compare/comparison.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// Compares bits, row by row or block by block, and measures how far the two are apart. Feed it a replay of
/// `scenario`, then ask for the verdict. Memory does not grow with the rows.
class RunComparer : public RowSink {
 public:
  /// Replays the rows of a kept block from its keyframe. If they give the kept digest, they are the kept
  /// rows: the row that differs is found exactly, and distances are taken over all rows. Asked only for
  /// blocks that differ.
  using Expand = std::function<RowBlock(const StoredBlock&)>;

  /// Refers to `kept`. REQUIRES: `expand` is a function.
  RunComparer(const StoredRun& kept, Expand expand) : kept_(kept), expand_(std::move(expand)) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = kept_.blocks.empty() ? 1 : 0, .contacts = true, .blocks = !kept_.blocks.empty()};
  }
  void rows(const Columns& batch) override;
  void contact_began(const Contact& contact) override { contacts_.push_back(contact); }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    contacts_[static_cast<std::size_t>(index)].last_step = last_step;
  }
  void block(const Block& block, std::int64_t count) override;

  /// What of the played run did not pass through the sink.
  struct Played {
    const Scenario& scenario;
    std::int64_t steps;
    std::string_view physics;
    std::string state_hash;
    Row final;
    std::vector<Input> inputs;
  };
  [[nodiscard]] Comparison finish(const Played& played);

 private:
  void check_upkeep(const StoredBlock& kept, const Block& block);
  [[nodiscard]] const RowBlock& expanded(const StoredBlock& kept);
  void compare(const StoredBlock& kept, const Block& played, std::int64_t played_repetition);
  [[nodiscard]] static Divergence find_by_checks(const StoredBlock& kept, std::int64_t first_step,
                                                 const RowBlock& played);
  void look_around(const Columns& batch, std::size_t index);
  void compare_ends(const Played& played);
  [[nodiscard]] std::string contradiction(const Played& played) const;
  [[nodiscard]] std::string difference_in_shape(const Played& played) const;

  const StoredRun& kept_;
  Expand expand_;
  std::vector<Contact> contacts_;
  std::int64_t rows_seen_ = 0;
  std::size_t kept_block_ = 0;        // The kept block that the next block is compared with,
  std::int64_t kept_block_used_ = 0;  // and how many of its repetitions were.
  RowBlock expanded_;                 // The rows of kept block `expanded_block_`; empty if not known.
  std::size_t expanded_block_ = SIZE_MAX;
  std::string damage_;  // What in the kept run contradicts itself.
  RunDistance distance_;
  Comparison result_;
};

/// The first field in which two rows differ in bits; nothing where none does. A NaN differs from
/// everything.
[[nodiscard]] std::optional<Divergence> first_difference(const Row& expected, const Row& actual);

}  // namespace hyrax

// A run, as it is played, against the one that is kept.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sim/compare/comparison.h"
#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// Compares bits, row by row or block by block, and measures how far the two are apart. Feed it a replay of
/// `scenario`, then ask for the verdict. Memory does not grow with the rows.
class RunComparer : public ContactRecorder {
 public:
  /// Replays the rows of a kept block from its keyframe. If they give the kept digest, they are the kept
  /// rows: the row that differs is found exactly, and distances are taken over all rows. Asked only for
  /// blocks that differ.
  using Expand = std::function<RowBlock(const StoredBlock&)>;

  /// Refers to `kept`. REQUIRES: `expand` is a function.
  /// @param other_walls whose contacts have other sources in the two runs: they are left to the caller.
  RunComparer(const StoredRun& kept, Expand expand, int other_walls = 0)
      : kept_(kept), expand_(std::move(expand)), other_walls_(other_walls), distance_(other_walls) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = kept_.blocks.empty() ? 1 : 0, .contacts = true, .blocks = !kept_.blocks.empty()};
  }
  void row(const Row& actual) override;
  void block(const Block& block, std::int64_t count) override;

  /// The distance is that of steps; where it should be taken at equal times, it only says so. Since when the
  /// kept run has settled is not known yet.
  /// @param scenario that was played; physics by which model; summary of that run.
  [[nodiscard]] Comparison finish(const Scenario& scenario, std::string_view physics,
                                  const RunSummary& summary);

 private:
  void check_upkeep(const StoredBlock& kept, const Block& block);
  [[nodiscard]] const RowBlock& expanded(const StoredBlock& kept);
  void compare(const StoredBlock& kept, const Block& played, std::int64_t played_repetition);
  [[nodiscard]] static Divergence find_by_checks(const StoredBlock& kept, std::int64_t first_step,
                                                 const RowBlock& played);
  void compare_ends(const Row& final);
  [[nodiscard]] std::string contradiction(const Scenario& scenario, const RunSummary& summary) const;
  [[nodiscard]] std::string difference_in_shape(const Scenario& scenario, const RunSummary& summary) const;

  const StoredRun& kept_;
  Expand expand_;
  int other_walls_;
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

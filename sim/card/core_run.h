// A run of any core as its rows.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// Of longer runs that do not repeat, only so many rows are kept and compared one by one; of the others the
/// hash says whether they are the same, up to kCoreRunStepsMax.
inline constexpr std::int64_t kCoreRunRowsMax = 400'000;
inline constexpr std::int64_t kCoreRunStepsMax = 20'000'000;

/// Row k, for any k of the run, is rows[k], or where the run repeats itself one of its last period.
struct CoreRun {
  std::vector<Row> rows;                 ///< From row 0.
  std::optional<Repetition> repetition;  ///< If its first period is kept.
  Row final;                             ///< The last one that was played, kept or not.
  Digest hash{};  ///< Of all rows that were played, without contacts: cores may tell those otherwise.
  std::optional<double> at_rest_since_s;
  bool is_finite = true;
  bool is_cut = false;  ///< There are rows that are neither kept nor repeat others.

  /// Appends rows of the period up to a length. REQUIRES: it repeats, or has that length.
  void extend(std::size_t length);
};

[[nodiscard]] CoreRun play_by(const Core& core, const Scenario& scenario);

/// Whether a run settles, played on by the core for kPlayedOn_s where it moved within the last second of its
/// file. Not if its clock adds no time.
[[nodiscard]] bool settles(const Core& core, const Scenario& scenario, const CoreRun& run);
inline constexpr double kPlayedOn_s = 20.0;

/// How a scenario's run by one core differs from that by another.
struct RunChange {
  bool has_same_bits = true;
  std::optional<DifferenceClass> difference = {};  ///< Where bits differ.
  ContactChanges contacts = {};
  std::int64_t contacts_before = 0;  ///< Of the base,
  std::int64_t contacts_after = 0;   ///< and of the candidate.
  std::optional<WorstDistance> largest = {};
  double end_shift_px = 0.0;       ///< Distance of the final rows; infinite where it is not a number.
  bool is_cut = false;             ///< Rows past kCoreRunRowsMax differ, but were not compared.
  bool became_non_finite = false;  ///< In the candidate, not in the base.
  bool no_longer_settles = false;  ///< Played on as well (settles), but it does with the base.
};

/// Extends the runs to a common length.
[[nodiscard]] RunChange compare_runs(const Scenario& scenario, CoreRun& base, CoreRun& candidate);

}  // namespace hyrax

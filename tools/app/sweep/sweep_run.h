// Computes a sweep of any core, or a part of one, into its result file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/ensemble/ensemble.h"
#include "tools/app/command_line/options.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/ensemble_file.h"

namespace hyrax {

/// What playing some members of a sweep came to.
struct SweepTally : StepTally {
  std::int64_t early_ends = 0;       ///< Members whose run ended before its last frame.
  std::string first_early_end = {};  ///< "member 3: row 12: WHY".

  SweepTally& operator+=(const SweepTally& other);
};

/// Plays `count` rows of a part from `first_row` on, and puts what is kept of them in place of the rows of
/// the tables before /inputs.
using RowPlayer = std::function<SweepTally(const WorkPart& part, std::int64_t first_row, std::int64_t count,
                                           std::vector<Table>& tables)>;

/// A sweep that was read, and how it is played.
struct PlayableSweep {
  EnsembleContents contents = {};
  std::string text = {};       ///< As SweepDocument's.
  std::string base_path = {};  ///< As SweepDocument's.
  /// Rows that a thread plays at once: about a tenth of a second, so that threads wait little for each other.
  std::int64_t chunk_rows = 1;
  std::function<RowPlayer()> make_player = {};                       ///< Called for each thread, in it.
  std::function<std::string(std::int64_t member)> member_text = {};  ///< The text of its scenario file.
};
/// Refers to the core.
[[nodiscard]] PlayableSweep paper_sweep(const Core& core, SweepFile file);

/// A core whose sweeps are played.
struct SweptCore {
  EnsembleHead head = {};  ///< What every result says of the core; the rest is left out.
  std::function<PlayableSweep(const std::string& path)> load = {};
  ReadContents read_contents = {};
};

/// The command sweep. @param swept of the core that the program gives.
[[nodiscard]] Command sweep_command_of(std::function<SweptCore(const Core& core)> swept);

/// Computes the rows of the head's part into a result file; the same file whatever the threads.
/// ERRORS: as EnsembleWriter, and what players throw.
[[nodiscard]] SweepTally compute_sweep(const PlayableSweep& sweep, const EnsembleHead& head,
                                       const std::string& output, std::int64_t threads);

struct MergeOutcome {
  EnsembleHead head;
  std::vector<std::string> missing;  ///< Paths of the missing parts; if there are any, nothing was written.
};

/// Joins the parts of a sweep into one result file.
/// ERRORS: Failure(bad_input) if a file is no part of the same sweep, or given twice; Failure(cannot_access).
[[nodiscard]] MergeOutcome merge_parts(const std::vector<std::string>& paths,
                                       const ReadContents& read_contents, const std::string& output);

/// "FILE.part-I-of-N.h5" for FILE.h5.
[[nodiscard]] std::string part_path(const std::string& path, const WorkPart& part);

}  // namespace hyrax

// Computes a sweep, or a part of one, into its result file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "tools/hyrax-sim/sweep/partial_result.h"

namespace hyrax {

struct SweepJob {
  EnsembleHead head;
  std::string output;
  std::int64_t threads = 1;
  Existing existing = Existing::refused;
};

struct SweepOutcome {
  std::int64_t rows = 0;
  std::int64_t rows_resumed = 0;  ///< Done by an earlier process.
  StepTally tally;                ///< Of the rows computed now.
  double elapsed_s = 0.0;
};

/// Computes what is not done yet; the same file whatever the threads and however often it was resumed.
/// ERRORS: as PartialResult and EnsembleWriter.
[[nodiscard]] SweepOutcome compute_sweep(const Sweep& sweep, const SweepJob& job);

struct MergeOutcome {
  EnsembleHead head;
  std::vector<std::string> missing;  ///< Paths of the missing parts; if there are any, nothing was written.
};

/// Joins the parts of a sweep into one result file.
/// ERRORS: Failure(bad_input) if a file is no part of the same sweep, or given twice; Failure(cannot_access).
[[nodiscard]] MergeOutcome merge_parts(const std::vector<std::string>& paths, const std::string& output);

/// "FILE.part-I-of-N.h5" for FILE.h5.
[[nodiscard]] std::string part_path(const std::string& path, const WorkPart& part);

}  // namespace hyrax

// Computes a sweep, or a part of one, into its result file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/ensemble/ensemble.h"
#include "tools/store/ensemble_file.h"

namespace hyrax {

/// Computes the rows of the head's part into a result file; the same file whatever the threads.
/// ERRORS: as EnsembleWriter.
[[nodiscard]] StepTally compute_sweep(const Core& core, const Sweep& sweep, const EnsembleHead& head,
                                      const std::string& output, std::int64_t threads);

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

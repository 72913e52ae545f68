// Golden files: a run as a trajectory file, every row of a short one, block digests of a long one.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/stored_run.h"
#include "tools/files/atomic_file.h"

namespace hyrax {

/// Writes the run into the file's part; the caller commits it.
/// ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON".
void write_golden(const AtomicFile& target, const std::string& path, const StoredRun& run);

/// REQUIRES: as read_on_trial.
/// ERRORS: as TrajectoryFile's.
[[nodiscard]] StoredRun read_golden(const std::string& path);

/// Where a golden file says in words, its provenance aside, what write_golden does not: in its attributes,
/// which hold no run, or in what stands in it besides. Nothing where it does not.
/// REQUIRES: as read_on_trial.
/// ERRORS: as TrajectoryFile's.
[[nodiscard]] std::optional<std::string> golden_words_fault(const std::string& path);

}  // namespace hyrax

// Golden files: a run as a trajectory file, with every row of a short run, block hashes of a long one.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/stored_run.h"
#include "tools/platform/atomic_file.h"

namespace hyrax {

/// Writes the run into the file's part; the caller commits it.
/// ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON".
void write_golden(AtomicFile& target, const std::string& path, const StoredRun& run);

/// REQUIRES: as read_isolated.
/// ERRORS: as TrajectoryFile's.
[[nodiscard]] StoredRun read_golden(const std::string& path);

/// Makes read_golden of these files cheap: one child process reads them all first (see
/// read_isolated_together). REQUIRES: this process has no other thread.
void read_goldens_ahead(const std::vector<std::string>& paths);

/// The first object or attribute of a golden file, /provenance aside, that bless would not write for the
/// run, or would write and the file lacks: what no comparison of rows or contents covers. Nothing if there is
/// none.
/// @param run as read from the file.
/// @param may_have_fewer whether what the file lacks is no difference.
/// REQUIRES: as read_isolated.
/// ERRORS: as read_isolated's.
[[nodiscard]] std::optional<std::string> attribute_difference(const std::string& path, const StoredRun& run,
                                                              bool may_have_fewer);

}  // namespace hyrax

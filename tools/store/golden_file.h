// Golden files: a run as a trajectory file, with every row of a short run, block hashes of a long one.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/stored_run.h"
#include "tools/files/atomic_file.h"

namespace hyrax {

/// Writes the run into the file's part; the caller commits it.
/// ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON".
void write_golden(const AtomicFile& target, const std::string& path, const StoredRun& run);

/// REQUIRES: as read_isolated.
/// ERRORS: as TrajectoryFile's.
[[nodiscard]] StoredRun read_golden(const std::string& path);

/// The first object or attribute of a golden file, /provenance aside, that bless would not write for the
/// run: what no comparison of rows or contents covers. Nothing if there is none.
/// @param run as read from the file.
/// REQUIRES: as read_isolated.
/// ERRORS: as read_isolated's.
[[nodiscard]] std::optional<std::string> attribute_difference(const std::string& path, const StoredRun& run);

/// Whether the file has every object and attribute that bless would write for the run, and no other.
/// @param run, REQUIRES, ERRORS: as attribute_difference's.
[[nodiscard]] bool has_all_attributes(const std::string& path, const StoredRun& run);

}  // namespace hyrax

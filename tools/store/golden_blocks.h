// The group /blocks of a golden file of a long run: a hash for each 4,096 rows, and the state they begin
// with.
#pragma once

#include "sim/trajectory/stored_run.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

/// Writes /blocks. The state at each block's first row is in /trajectory.
/// Returns false if the file could not be written.
[[nodiscard]] bool write_blocks(hid_t file, const std::vector<StoredBlock>& blocks);

/// Reads the blocks and the final row. REQUIRES: the file has /blocks; `run.steps` is set.
/// ERRORS: Failure(bad_input) if the blocks do not cover the run, as TrajectoryFile's.
void read_blocks(const TrajectoryFile& file, StoredRun& run);

}  // namespace hyrax

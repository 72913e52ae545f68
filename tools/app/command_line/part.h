// Which part of the work this process does: as the user asks, or as a cluster's scheduler says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/scenario/sweep.h"

namespace hyrax {

/// The part that `--part I/N` names (empty: not given). Without it, I and N are taken from
///   SLURM_ARRAY_TASK_ID less _MIN (0 if unset) by _STEP (1 if unset), and SLURM_ARRAY_TASK_COUNT;
///   OMPI_COMM_WORLD_RANK and OMPI_COMM_WORLD_SIZE;
///   JOB_COMPLETION_INDEX, and `--parts N`,
/// the first pair that is set, which is reported on standard error, as is half a pair. Nothing if none is.
/// @param command begins the messages, as "hyrax-sim fuzz".
/// ERRORS: Failure(bad_input) if a value is no number, an index is between two steps, I is not 0 .. N - 1, or
/// --parts has no index.
[[nodiscard]] std::optional<WorkPart> choose_part(const std::string& command, const std::string& part,
                                                  std::optional<std::int64_t> parts);

}  // namespace hyrax

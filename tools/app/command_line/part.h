// Which part of the work this process does, as the user asks or as a cluster's scheduler says, and its
// threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "sim/scenario/sweep.h"
#include "tools/platform/process.h"

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

/// The processors that this process may use; at least 1.
[[nodiscard]] inline std::int64_t processors() {
  return std::max<std::int64_t>(1, std::thread::hardware_concurrency());
}

/// As many threads as requested, or fewer if the system allows no more. What a thread takes of a limited
/// address space, its stack and its heap, is not given back when it ends: below 128 MiB there is none.
[[nodiscard]] std::vector<std::jthread> start_workers(std::int64_t count, const auto& work) {
  constexpr std::uint64_t kBytesPerWorker = 128 << 20;
  if (const auto space = address_space_bytes_max())
    count = std::min(count, static_cast<std::int64_t>(*space / kBytesPerWorker));
  std::vector<std::jthread> workers;
  try {
    for (std::int64_t worker = 0; worker < count; ++worker) workers.emplace_back(work);
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  return workers;
}

}  // namespace hyrax

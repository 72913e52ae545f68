// Threads that work beside the main one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "tools/platform/process.h"

namespace hyrax {

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

// Threads that work beside the main one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace hyrax {

/// The processors that this process may use; at least 1.
[[nodiscard]] inline std::int64_t processors() {
  return std::max<std::int64_t>(1, std::thread::hardware_concurrency());
}

/// As many threads as requested, or fewer if the system allows no more.
[[nodiscard]] inline std::vector<std::jthread> start_workers(std::int64_t count,
                                                             const std::function<void()>& work) {
  std::vector<std::jthread> workers;
  try {
    for (std::int64_t worker = 0; worker < count; ++worker) workers.emplace_back(work);
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  return workers;
}

}  // namespace hyrax

#include "tools/store/isolated_read.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <set>
#include <stdexcept>
#include <tuple>

#include "tools/files/failure.h"
#include "tools/platform/file_state.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {
namespace {

// More than any undamaged file needs, a compressed one too, and no longer than a user would wait.
ChildLimits limits_for(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMemoryMin = 128 << 20;
  constexpr std::uint64_t kMemoryPerByte = 8;
  constexpr std::uint64_t kTimeMin_s = 1;
  constexpr std::uint64_t kBytesPerSecond = 2 << 20;
  constexpr double kWaitPerTime = 20.0;  // On a busy machine, or if it sleeps.
  const std::uint64_t time_s = kTimeMin_s + file_bytes / kBytesPerSecond;
  return {.wall_s = kWaitPerTime * static_cast<double>(time_s),
          .processor_s = time_s,
          .memory_bytes = kMemoryMin + kMemoryPerByte * file_bytes};
}

// What is wrong with a file that does not end its process; empty if it can be read, or is refused.
std::string damage_by(const std::function<void()>& read) {
  constexpr const char* kTooMuchMemory = "reading it takes too much memory for its size";
  try {
    read();
  } catch (const Failure&) {
    return {};
  } catch (const std::bad_alloc&) {
    return kTooMuchMemory;
  } catch (const std::length_error&) {
    return kTooMuchMemory;
  } catch (const std::exception&) {
    return "reading it fails";
  }
  return {};
}

// A file as it was when it was read, whatever its name.
using FileVersion = std::tuple<decltype(identity_of("")), std::uintmax_t, std::filesystem::file_time_type>;

FileVersion version_of(const std::string& path) {
  std::error_code unknown;  // No file has the version of one that is unknown.
  return {identity_of(path), std::filesystem::file_size(path, unknown),
          std::filesystem::last_write_time(path, unknown)};
}

// The files that cannot harm this process; in a child process nothing needs another.
std::set<FileVersion> harmless;
bool is_child = false;

// Reads files of so many bytes in a child process. @param damage as damage_by.
std::string damage_in_child(const std::string& path, std::uint64_t bytes,
                            const std::function<std::string()>& damage) {
  const WorkEnd end = in_child(path + ": cannot be read", limits_for(bytes), [&] {
    is_child = true;
    return damage();
  });
  if (end.result) return *end.result;
  return end.is_timed_out() ? "reading it does not end" : "the HDF5 library crashes on it";
}

std::uint64_t bytes_of(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : bytes;
}

}  // namespace

void read_isolated(const std::string& path, const std::function<void()>& read) {
  if (!guards_work() || is_child || harmless.contains(version_of(path))) return;
  if (const int error = error_of_reading(path)) fail_to_read(path, error);
  const std::string damage = damage_in_child(path, bytes_of(path), [&] { return damage_by(read); });
  if (!damage.empty()) refuse_input(path + ": is damaged: " + damage + "; copy it again, or write it again");
}

void read_isolated_together(const std::vector<std::string>& paths,
                            const std::function<void(const std::string& path)>& read) {
  if (paths.size() < 2 || !guards_work()) return;
  std::uint64_t bytes = 0;
  std::vector<FileVersion> versions;
  for (const std::string& path : paths) {
    bytes += bytes_of(path);
    versions.push_back(version_of(path));
  }
  const auto read_each = [&] {
    std::string damage;
    for (auto path = paths.begin(); path != paths.end() && damage.empty(); ++path)
      damage = damage_by([&] { read(*path); });
    return damage;
  };
  try {
    if (damage_in_child(paths.front(), bytes, read_each).empty())
      harmless.insert(versions.begin(), versions.end());
  } catch (const Failure&) {  // Reading each by itself reports it.
  }
}

}  // namespace hyrax

#include "tools/store/isolated_read.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <set>
#include <stdexcept>
#include <tuple>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/files/signal_cleanup.h"

namespace hyrax {
namespace {

// Sanitizers use other codes.
enum ChildExit { survived = 0, out_of_memory = 40, other_error = 41 };

// The address space in use already; a sanitizer maps terabytes.
std::uint64_t mapped_bytes() {
  unsigned long long pages = 0;
  std::FILE* const file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  const bool is_read = std::fscanf(file, "%llu", &pages) == 1;
  std::fclose(file);
  return is_read ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void set_limit(int resource, std::uint64_t value) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, value);
  limit.rlim_max = limit.rlim_cur;
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

// More than any undamaged file needs, a compressed one too, and no longer than a user would wait.
void set_limits(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMemoryMin = 128 << 20;
  constexpr std::uint64_t kMemoryPerByte = 8;
  constexpr std::uint64_t kTimeMin_s = 1;
  constexpr std::uint64_t kBytesPerSecond = 2 << 20;
  constexpr std::uint64_t kWaitPerTime = 20;  // On a busy machine.
  set_limit(RLIMIT_CORE, 0);
  const std::uint64_t time_s = kTimeMin_s + file_bytes / kBytesPerSecond;
  set_limit(RLIMIT_CPU, time_s);
  alarm(static_cast<unsigned>(kWaitPerTime * time_s));  // If it sleeps instead.
  if (const std::uint64_t mapped = mapped_bytes(); mapped > 0)
    set_limit(RLIMIT_AS, mapped + kMemoryMin + kMemoryPerByte * file_bytes);
}

// A crash is an expected outcome here, so a sanitizer must not report it. This process may have inherited
// ignored or blocked signals.
void reset_signals() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU})
    std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (std::freopen("/dev/null", "w", stderr) == nullptr) close(STDERR_FILENO);
}

ChildExit exit_code_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const Failure&) {
    return survived;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  } catch (const std::length_error&) {
    return out_of_memory;
  } catch (const std::exception&) {
    return other_error;
  }
  return survived;
}

std::string damage_of(int status) {
  if (WIFEXITED(status))
    return WEXITSTATUS(status) == out_of_memory ? "reading it takes too much memory for its size"
                                                : "reading it fails";
  const int number = WTERMSIG(status);
  if (number == SIGXCPU || number == SIGKILL || number == SIGALRM) return "reading it does not end";
  return "the HDF5 library crashes on it";
}

// A file as it was when it was read, whatever its name.
using FileVersion = std::tuple<dev_t, ino_t, off_t, time_t, decltype(timespec::tv_nsec)>;

FileVersion version_of(const std::string& path) {
  struct stat state {};
  stat(path.c_str(), &state);  // No file has the version of one that is unknown.
  return {state.st_dev, state.st_ino, state.st_size, state.st_mtim.tv_sec, state.st_mtim.tv_nsec};
}

// The files that cannot harm this process; in a child process nothing needs another.
std::set<FileVersion> harmless;
bool is_child = false;

// What a child process that reads files of so many bytes ended with. ERRORS: no child process, or no status.
int status_of_child(const std::string& path, std::uint64_t bytes, const std::function<void()>& read) {
  const pid_t child = fork_until_end();
  if (child < 0)
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: cannot create a child process");
  if (child == 0) {
    is_child = true;
    reset_signals();
    set_limits(bytes);
    _exit(exit_code_of(read));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw Failure(ExitCode::cannot_access,
                    path + ": cannot be read: the exit status of its child process is unknown: " +
                        std::strerror(errno));
  return status;
}

std::uint64_t bytes_of(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : bytes;
}

}  // namespace

void read_isolated(const std::string& path, const std::function<void()>& read) {
  if (is_child || harmless.contains(version_of(path))) return;
  if (access(path.c_str(), R_OK) != 0) fail_to_read(path, errno);
  const int status = status_of_child(path, bytes_of(path), read);
  if (status != survived)
    refuse_input(path + ": is damaged: " + damage_of(status) + "; copy it again, or write it again");
}

void read_isolated_together(const std::vector<std::string>& paths,
                            const std::function<void(const std::string& path)>& read) {
  if (paths.size() < 2) return;
  std::uint64_t bytes = 0;
  std::vector<FileVersion> versions;
  for (const std::string& path : paths) {
    bytes += bytes_of(path);
    versions.push_back(version_of(path));
  }
  const auto read_each = [&] {
    for (const std::string& path : paths) {
      const ChildExit exit = exit_code_of([&] { read(path); });
      if (exit != survived) _exit(exit);
    }
  };
  try {
    if (status_of_child(paths.front(), bytes, read_each) == survived)
      harmless.insert(versions.begin(), versions.end());
  } catch (const Failure&) {  // Reading each by itself reports it.
  }
}

void trust_own_file(const std::string& path) { harmless.insert(version_of(path)); }

}  // namespace hyrax

#include "tools/store/trial_reading.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/files/failure.h"

namespace hyrax {
namespace {

// Other codes are of sanitizers.
enum ChildExit { survived = 0, out_of_memory = 40, other_fault = 41 };

// What is mapped already; a sanitizer maps terabytes.
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

// More than any complete file takes, a compressed one too, and no more than a user would wait for.
void set_limits(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMemoryLeast = 128 << 20;
  constexpr std::uint64_t kMemoryPerByte = 8;
  constexpr std::uint64_t kTimeLeast_s = 1;
  constexpr std::uint64_t kBytesPerSecond = 2 << 20;
  constexpr std::uint64_t kWaitPerTime = 20;  // On a busy machine.
  set_limit(RLIMIT_CORE, 0);
  const std::uint64_t time_s = kTimeLeast_s + file_bytes / kBytesPerSecond;
  set_limit(RLIMIT_CPU, time_s);
  alarm(static_cast<unsigned>(kWaitPerTime * time_s));  // For one that waits instead.
  if (const std::uint64_t mapped = mapped_bytes(); mapped > 0)
    set_limit(RLIMIT_AS, mapped + kMemoryLeast + kMemoryPerByte * file_bytes);
}

// A crash is an answer here, not an event for a sanitizer's report. A parent may have left the signals of
// the limits ignored or blocked.
void die_silently() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU})
    std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (std::freopen("/dev/null", "w", stderr) == nullptr) close(STDERR_FILENO);
}

ChildExit outcome_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const Failure&) {
    return survived;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  } catch (const std::length_error&) {
    return out_of_memory;
  } catch (const std::exception&) {
    return other_fault;
  }
  return survived;
}

std::string damage_told_by(int status) {
  if (WIFEXITED(status))
    return WEXITSTATUS(status) == out_of_memory ? "reading it takes memory out of all proportion"
                                                : "reading it goes wrong";
  const int number = WTERMSIG(status);
  if (number == SIGXCPU || number == SIGKILL || number == SIGALRM)
    return "reading it does not come to an end";
  return "the HDF5 library crashes on it";
}

}  // namespace

void read_on_trial(const std::string& path, const std::function<void()>& read) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  const pid_t child = fork();
  if (child < 0)
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: no process for it can be made");
  if (child == 0) {
    die_silently();
    set_limits(unknown ? 0 : bytes);
    _exit(outcome_of(read));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw Failure(ExitCode::cannot_access,
                    path + ": cannot be read: the outcome of reading it in a child process is not known: " +
                        std::strerror(errno));
  if (status != survived)
    throw Failure(ExitCode::bad_input,
                  path + ": is damaged: " + damage_told_by(status) + "; write or copy it anew");
}

}  // namespace hyrax

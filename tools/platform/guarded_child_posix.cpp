#include "tools/platform/guarded_child.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/files/failure.h"

namespace hyrax {
namespace {

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

void set_limits(const ChildLimits& limits) {
  set_limit(RLIMIT_CORE, 0);
  if (limits.processor_s) set_limit(RLIMIT_CPU, *limits.processor_s);
  if (limits.wall_s) limit_wall_time(*limits.wall_s);
  if (const std::uint64_t mapped = mapped_bytes(); limits.memory_bytes && mapped > 0)
    set_limit(RLIMIT_AS, mapped + *limits.memory_bytes);
}

// A crash is an expected outcome here, so a sanitizer must not report it.
void reset_signals() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU})
    std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

// A copy would keep what this process has open and locked: it is killed when this one ends, even by SIGKILL.
pid_t fork_until_end() {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // It had ended before.
  return 0;
}

constexpr char kHasReturned = '=';  // Before the result, which may be empty.

[[noreturn]] void work_as_child(int result_end, const std::function<std::string()>& work) noexcept {
  const std::string result = kHasReturned + work();
  for (std::size_t at = 0; at < result.size();) {
    const ssize_t count = write(result_end, result.data() + at, result.size() - at);
    if (count < 0 && errno != EINTR) break;
    if (count > 0) at += static_cast<std::size_t>(count);
  }
  _exit(0);
}

// All that is written until the last writer ends.
std::string read_all(int end) {
  std::string all;
  char buffer[1 << 12];
  while (true) {
    const ssize_t count = read(end, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return all;
    all.append(buffer, static_cast<std::size_t>(count));
  }
}

}  // namespace

bool WorkEnd::is_timed_out() const {
  return signal == SIGALRM || signal == SIGXCPU || signal == SIGKILL;  // The last follows SIGXCPU.
}

std::string WorkEnd::signal_text() const {
  return signal == 0 ? "" : "signal " + std::to_string(signal) + " (SIG" + sigabbrev_np(signal) + ")";
}

void limit_wall_time(double limit_s) {
  constexpr double kTick_s = 1e-6;
  const double whole_s = std::floor(limit_s);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(std::min(whole_s, 1e9));
  timer.it_value.tv_usec = static_cast<suseconds_t>((limit_s - whole_s) / kTick_s);
  if (limit_s < kTick_s) timer.it_value.tv_usec = 1;  // 0 would be no limit.
  setitimer(ITIMER_REAL, &timer, nullptr);
}

namespace {

// @param act what the child does; it writes its result to the end of a pipe, and does not return.
WorkEnd end_of_child(const std::string& what, const ChildLimits& limits,
                     const std::function<void(int result_end)>& act) {
  int ends[2];
  const bool has_pipe = pipe2(ends, O_CLOEXEC) == 0;
  const pid_t child = has_pipe ? fork_until_end() : -1;
  if (child == 0) {
    reset_signals();
    set_limits(limits);
    if (limits.is_silent && std::freopen("/dev/null", "w", stderr) == nullptr) close(STDERR_FILENO);
    act(ends[1]);
  }
  if (has_pipe) close(ends[1]);
  const std::string result = child > 0 ? read_all(ends[0]) : "";
  if (has_pipe) close(ends[0]);
  if (child < 0) throw Failure(ExitCode::cannot_access, what + ": cannot create a child process");
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      throw Failure(ExitCode::cannot_access,
                    what + ": the exit status of its child process is unknown: " + std::strerror(errno));
  if (WIFSIGNALED(status)) return {.result = {}, .signal = WTERMSIG(status)};
  if (status != 0) return {};
  return {.result = result, .signal = 0};
}

// @param execute starts a program in the child process; if it returns, there is no such program.
WorkEnd end_of_program(const std::string& what, const ChildLimits& limits, std::vector<std::string> arguments,
                       const std::function<void(char** words)>& execute) {
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  return end_of_child(what, limits, [&](int result_end) {
    if (dup2(result_end, STDOUT_FILENO) >= 0) execute(words.data());
    _exit(1);
  });
}

}  // namespace

bool guards_work() { return true; }

WorkEnd in_child(const std::string& what, const ChildLimits& limits,
                 const std::function<std::string()>& work) {
  WorkEnd end = end_of_child(what, limits, [&](int result_end) { work_as_child(result_end, work); });
  if (!end.result || !end.result->starts_with(kHasReturned)) return {.result = {}, .signal = end.signal};
  return {.result = end.result->substr(1), .signal = 0};
}

WorkEnd in_new_process(const std::string& what, std::vector<std::string> arguments) {
  return end_of_program(what, {.is_silent = false}, std::move(arguments),
                        [](char** words) { execv("/proc/self/exe", words); });
}

std::optional<std::string> printed_by(std::vector<std::string> words) try {
  return end_of_program(words.front(), {}, words, [](char** program) { execvp(program[0], program); }).result;
} catch (const Failure&) {
  return std::nullopt;
}

}  // namespace hyrax

#include "tools/files/child_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" {
#include <sys/pidfd.h>  // Debian 12's declares C functions without saying so.
}

#include "tools/files/failure.h"
#include "tools/files/signal_cleanup.h"

extern char** environ;

namespace hyrax {
namespace {

Failure cannot_start(const std::string& program, int error_number) {
  return {ExitCode::cannot_access, program + ": cannot be started: " + std::strerror(error_number)};
}

class Descriptor {
 public:
  Descriptor(int number, const std::string& program) : number_(number) {
    if (number_ < 0) throw cannot_start(program, errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// What the child reads.
void fill(const Descriptor& file, const std::string& program, std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = pwrite(file.number(), text.data() + at, text.size() - at, static_cast<off_t>(at));
    if (count < 0 && errno != EINTR) throw cannot_start(program, errno);
    if (count > 0) at += static_cast<std::size_t>(count);
  }
}

// What the child prints: the first bytes are kept, the others are read, so that it never waits.
class Capture {
 public:
  Capture(const std::string& program, std::size_t bytes_max) : bytes_max_(bytes_max) {
    if (pipe2(ends_, O_CLOEXEC) != 0) throw cannot_start(program, errno);
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  ~Capture() {
    close(ends_[0]);
    close_child_end();
  }

  [[nodiscard]] int child_end() const { return ends_[1]; }
  void close_child_end() { close(std::exchange(ends_[1], -1)); }
  /// For poll; none any more if all was read.
  [[nodiscard]] pollfd watched() const {
    return {.fd = is_at_end_ ? -1 : ends_[0], .events = POLLIN, .revents = 0};
  }
  /// Reads what is there. False if nothing was.
  bool read_some() {
    char buffer[1 << 16];
    const ssize_t count = is_at_end_ ? 0 : read(ends_[0], buffer, sizeof buffer);
    is_at_end_ = is_at_end_ || count == 0;
    if (count <= 0) return false;
    text_.append(buffer, std::min(static_cast<std::size_t>(count), bytes_max_ - text_.size()));
    return true;
  }
  /// All that was printed. REQUIRES: the child ended.
  [[nodiscard]] std::string take() {
    constexpr int kReadsMax = 64;  // What a pipe can hold; another process may keep filling it.
    for (int reads = 0; reads < kReadsMax && read_some();) ++reads;
    return std::move(text_);
  }

 private:
  int ends_[2] = {-1, -1};
  std::size_t bytes_max_;
  bool is_at_end_ = false;
  std::string text_;
};

// The child gets these streams, and a process group of its own, so that all of it can be killed.
pid_t start(const std::vector<std::string>& arguments, int in, int out, int err) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words[0], &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw cannot_start(arguments.front(), error);
  return child;
}

using SteadyClock = std::chrono::steady_clock;

// Reads what the child prints until it ends. Whether it ended within the time.
bool wait_for(const Descriptor& child, Capture& out, Capture& err, std::optional<double> limit_s) {
  constexpr double kLimitMax_s = 1e6;
  const SteadyClock::time_point begin = SteadyClock::now();
  while (true) {
    int left_ms = -1;
    if (limit_s) {
      const std::chrono::duration<double> passed = SteadyClock::now() - begin;
      const double left_s = std::min(*limit_s, kLimitMax_s) - passed.count();
      if (left_s <= 0.0) return false;
      left_ms = static_cast<int>(std::ceil(left_s * 1e3));
    }
    std::array<pollfd, 3> watched = {
        {{.fd = child.number(), .events = POLLIN, .revents = 0}, out.watched(), err.watched()}};
    if (poll(watched.data(), watched.size(), left_ms) <= 0) continue;
    if (watched[1].revents != 0) out.read_some();
    if (watched[2].revents != 0) err.read_some();
    if (watched[0].revents != 0) return true;
  }
}

int reap(pid_t child, const std::string& program) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw cannot_start(program, errno);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, std::string_view input,
                   std::optional<double> limit_s, std::size_t out_bytes_max) {
  const std::string& program = arguments.front();
  constexpr std::size_t kErrBytesMax = 64 << 10;
  const Descriptor in(memfd_create("hyrax-child", MFD_CLOEXEC), program);
  fill(in, program, input);
  Capture out(program, out_bytes_max);
  Capture err(program, kErrBytesMax);
  const pid_t child = start(arguments, in.number(), out.child_end(), err.child_end());
  kill_group_on_signal(child);
  out.close_child_end();
  err.close_child_end();
  ChildEnd end;
  {
    const Descriptor watched(pidfd_open(child, 0), program);
    end.is_timed_out = !wait_for(watched, out, err, limit_s);
  }
  kill(-child, SIGKILL);  // The child is not reaped yet: no other process can have its group's number.
  spare_group_on_signal(child);
  end.exit_code = reap(child, program);
  end.out = out.take();
  end.err = err.take();
  return end;
}

std::string end_text(const ChildEnd& end, double limit_s) {
  if (end.is_timed_out) return fmt::format("no end within {:.3g} s", limit_s);
  if (end.exit_code > 128) return fmt::format("signal {} (exit code {})", end.exit_code - 128, end.exit_code);
  return fmt::format("exit code {}", end.exit_code);
}

}  // namespace hyrax

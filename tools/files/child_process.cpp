#include "tools/files/child_process.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" {
#include <sys/pidfd.h>  // Debian 12's declares C functions without saying so.
}

extern char** environ;

namespace hyrax {
namespace {

class Descriptor {
 public:
  Descriptor(int number, const std::string& program) : number_(number) {
    if (number_ < 0) throw CannotStart(program, errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

class MemoryFile : public Descriptor {
 public:
  explicit MemoryFile(const std::string& program)
      : Descriptor(memfd_create("hyrax-child", MFD_CLOEXEC), program) {}
  MemoryFile(const std::string& program, std::string_view text) : MemoryFile(program) {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = pwrite(number(), text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (count < 0 && errno != EINTR) throw CannotStart(program, errno);
      if (count > 0) at += static_cast<std::size_t>(count);
    }
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    char buffer[1 << 14];
    for (ssize_t count = 0;
         (count = pread(number(), buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0;)
      text.append(buffer, static_cast<std::size_t>(count));
    return text;
  }
};

// The child's streams, and a process group of its own, so that all of it can be killed.
class SpawnSettings {
 public:
  SpawnSettings(const MemoryFile& in, const MemoryFile& out, const MemoryFile& err) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, in.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files_, out.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files_, err.number(), STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }

  [[nodiscard]] const posix_spawn_file_actions_t* files() const { return &files_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

pid_t start(const std::vector<std::string>& arguments, const SpawnSettings& settings) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  pid_t child = 0;
  if (const int error =
          posix_spawnp(&child, words[0], settings.files(), settings.attributes(), words.data(), environ);
      error != 0)
    throw CannotStart(arguments.front(), error);
  return child;
}

// Whether the child ended within the time.
bool wait_for(const Descriptor& child, std::optional<double> limit_s) {
  pollfd ended{.fd = child.number(), .events = POLLIN, .revents = 0};
  int count = 0;
  while ((count = poll(&ended, 1, limit_s ? static_cast<int>(*limit_s * 1e3) : -1)) < 0 && errno == EINTR) {
  }
  return count > 0;
}

int reap(pid_t child, const std::string& program) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw CannotStart(program, errno);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

CannotStart::CannotStart(const std::string& program, int error_number)
    : Failure(ExitCode::cannot_access, program + ": cannot be started: " + std::strerror(error_number)),
      error_number_(error_number) {}

bool CannotStart::is_missing() const { return error_number_ == ENOENT; }

ChildEnd run_child(const std::vector<std::string>& arguments, std::string_view input,
                   std::optional<double> limit_s) {
  const std::string& program = arguments.front();
  const MemoryFile in(program, input);
  const MemoryFile out(program);
  const MemoryFile err(program);
  const pid_t child = start(arguments, SpawnSettings(in, out, err));
  ChildEnd end;
  {
    const Descriptor watched(pidfd_open(child, 0), program);
    end.is_timed_out = !wait_for(watched, limit_s);
  }
  kill(-child, SIGKILL);  // The child is not reaped yet: no other process can have its group's number.
  end.exit_code = reap(child, program);
  end.out = out.text();
  end.err = err.text();
  return end;
}

std::string end_text(const ChildEnd& end, double limit_s) {
  if (end.is_timed_out) return fmt::format("no end within {} s", limit_s);
  if (end.exit_code > 128) return fmt::format("signal {} (exit code {})", end.exit_code - 128, end.exit_code);
  return fmt::format("exit code {}", end.exit_code);
}

}  // namespace hyrax

#include "tools/files/signal_cleanup.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hyrax {
namespace {

std::array<std::atomic<const char*>, 16> removed_paths{};
std::array<std::atomic<int>, 256> killed_groups{};
std::atomic<const char*> said_last{};
static_assert(std::atomic<const char*>::is_always_lock_free);

template <class List, class Value>
void replace_one(List& list, Value from, Value to) {
  for (auto& each : list)
    if (Value expected = from; each.compare_exchange_strong(expected, to)) return;
}

void end_by(int signal) {
  clean_up_for_signal();
  if (const char* const text = said_last.load())
    static_cast<void>(!write(STDERR_FILENO, text, std::strlen(text)));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// A signal that is ignored is never handled, not for a moment either.
void handle_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, end_by);
  }
}

void remove_folder(const char* path) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/rm", "rm", "-rf", "--", path, nullptr);
    _exit(1);
  }
  if (child > 0) waitpid(child, nullptr, 0);
}

}  // namespace

void remove_on_signal(const std::string& path) {
  replace_one<decltype(removed_paths), const char*>(removed_paths, nullptr, path.c_str());
  handle_signals();
}

void keep_on_signal(const std::string& path) {
  replace_one<decltype(removed_paths), const char*>(removed_paths, path.c_str(), nullptr);
}

void kill_group_on_signal(int group) {
  replace_one(killed_groups, 0, group);
  handle_signals();
}

void spare_group_on_signal(int group) { replace_one(killed_groups, group, 0); }

void say_on_signal(const char* text) {
  said_last = text;
  handle_signals();
}

pid_t fork_until_end() {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // It had ended before.
  }
  return child;
}

void clean_up_for_signal() noexcept {
  for (const std::atomic<int>& group : killed_groups)
    if (group.load() != 0) kill(-group.load(), SIGKILL);
  for (const std::atomic<const char*>& removed : removed_paths) {
    const char* const path = removed.load();
    if (path == nullptr || unlink(path) == 0) continue;
    if (errno == EISDIR || errno == EPERM) remove_folder(path);  // Linux and POSIX say so of a folder.
  }
}

}  // namespace hyrax

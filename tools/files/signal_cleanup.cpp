#include "tools/files/signal_cleanup.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

namespace hyrax {
namespace {

std::array<std::atomic<const char*>, 16> removed_paths{};
static_assert(std::atomic<const char*>::is_always_lock_free);

void replace_path(const char* from, const char* to) {
  for (std::atomic<const char*>& path : removed_paths)
    if (const char* expected = from; path.compare_exchange_strong(expected, to)) return;
}

void end_by(int signal) {
  clean_up_for_signal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// A signal that is ignored is never handled, not for a moment either.
void clean_up_on(int signal) {
  struct sigaction now {};
  if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, end_by);
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
  replace_path(nullptr, path.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) clean_up_on(signal);
}

void keep_on_signal(const std::string& path) { replace_path(path.c_str(), nullptr); }

void clean_up_for_signal() noexcept {
  for (const std::atomic<const char*>& removed : removed_paths) {
    const char* const path = removed.load();
    if (path == nullptr || unlink(path) == 0) continue;
    if (errno == EISDIR || errno == EPERM) remove_folder(path);  // Linux and POSIX say so of a folder.
  }
}

}  // namespace hyrax

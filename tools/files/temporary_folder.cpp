#include "tools/files/temporary_folder.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

#include "tools/files/failure.h"

namespace hyrax {
namespace {

// The paths of those that exist, for a signal handler; one more than these is left to its destructor.
std::array<std::atomic<const char*>, 8> existing_paths{};
static_assert(std::atomic<const char*>::is_always_lock_free);

void replace_path(const char* from, const char* to) {
  for (std::atomic<const char*>& path : existing_paths)
    if (const char* expected = from; path.compare_exchange_strong(expected, to)) return;
}

void end_by(int signal) {
  remove_temporary_folders();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// One that is ignored, as by nohup, stays ignored.
void remove_on(int signal) {
  if (const auto before = std::signal(signal, end_by); before != SIG_DFL) std::signal(signal, before);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const char* const parent = std::getenv("TMPDIR");
  path_ = std::string(parent != nullptr && *parent != '\0' ? parent : "/tmp") + "/hyrax-sim-XXXXXX";
  if (mkdtemp(path_.data()) == nullptr)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be created: " + std::strerror(errno));
  replace_path(nullptr, path_.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) remove_on(signal);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::string path = path_ + "/" + name;
  std::ofstream file(path, std::ios::binary);
  if (!(file << text).flush()) throw Failure(ExitCode::cannot_access, path + ": cannot be written");
  return path;
}

TemporaryFolder::~TemporaryFolder() {
  replace_path(path_.c_str(), nullptr);
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void remove_temporary_folders() noexcept {
  for (const std::atomic<const char*>& path : existing_paths) {
    const char* const folder = path.load();
    if (folder == nullptr) continue;
    const pid_t child = fork();
    if (child == 0) {
      execl("/bin/rm", "rm", "-rf", "--", folder, nullptr);
      _exit(1);
    }
    if (child > 0) waitpid(child, nullptr, 0);
  }
}

}  // namespace hyrax

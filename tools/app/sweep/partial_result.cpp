#include "tools/app/sweep/sweep_run.h"

#include <cerrno>
#include <cstdio>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/signal_cleanup.h"

namespace hyrax {
namespace {

// The lock tells a writer that another one is at work; it ends with its process.
int lock_file(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 && errno == ELOOP) refuse_input(path + ": is a link; `--force` replaces it");
  if (descriptor < 0) fail_to_write(path, errno);
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  const bool is_ours = fcntl(descriptor, F_OFD_SETLK, &whole) == 0 || (errno != EAGAIN && errno != EACCES);
  struct stat state {};
  const bool has_other_names = fstat(descriptor, &state) == 0 && state.st_nlink > 1;
  if (is_ours && !has_other_names) return descriptor;
  close(descriptor);
  if (is_ours) refuse_input(path + ": has a hard link, which would be written too; `--force` replaces it");
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: another process is writing it");
}

bool exists(const std::string& path) {
  struct stat state {};
  return lstat(path.c_str(), &state) == 0;
}

// Only the name goes: what a link leads to, or has another name, stays as it is.
void remove_existing(const std::string& path) {
  struct stat state {};
  if (lstat(path.c_str(), &state) == 0 && S_ISREG(state.st_mode) && state.st_nlink == 1)
    close(lock_file(path));
  if (unlink(path.c_str()) != 0) fail_to_write(path, errno);
}

}  // namespace

std::string partial_path(const std::string& path) { return path + ".partial"; }

PartialResult::PartialResult(const std::string& path, const EnsembleHead& head, const Sweep& sweep,
                             Existing existing)
    : path_(path), partial_(partial_path(path)), rows_(head.part.rows(head.members)) {
  if (is_folder(path)) fail_to_write(path, EISDIR);
  if (exists(partial_) && existing == Existing::refused) {
    if (is_regular_file(partial_)) close(lock_file(partial_));
    refuse_input(partial_ +
                 ": exists, from a sweep that did not end; `--resume` continues it, `--force` starts over");
  }
  if (exists(partial_) && existing == Existing::replaced) remove_existing(partial_);
  if (!exists(partial_)) {
    AtomicFile file(partial_);
    create_ensemble(file.part_path(), path_, head, sweep);
    file.commit_as_new();
  }
  lock_ = lock_file(partial_);
  take_mode(lock_, path_, S_IRUSR | S_IWUSR);
}

PartialResult::~PartialResult() {
  say_on_signal(nullptr);
  close(lock_);
}

void PartialResult::note_done(std::int64_t rows) {
  struct stat state {};
  constexpr std::uint64_t kBlockBytes = 512;
  const std::uint64_t bytes =
      fstat(lock_, &state) == 0 ? kBlockBytes * static_cast<std::uint64_t>(state.st_blocks) : 0;
  auto words = std::make_unique<const std::string>(fmt::format(
      "{}{}: {} of {} members are done, {}; the same command with `--resume` continues\n",
      isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "", printable(partial_), rows, rows_, size_text(bytes)));
  say_on_signal(words->c_str());
  last_words_ = std::move(words);
}

void PartialResult::commit() {
  take_mode(lock_, path_, 0);
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
}

}  // namespace hyrax

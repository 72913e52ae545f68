#include "tools/platform/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/platform/path.h"
#include "tools/platform/signal_cleanup.h"

namespace hyrax {
namespace {

// Also of a link whose target does not exist yet.
std::string link_target(const std::string& path) {
  constexpr int kLinksMax = 40;
  std::error_code unknown;
  std::filesystem::path target = path;
  for (int links = 0; links < kLinksMax && std::filesystem::is_symlink(target, unknown); ++links)
    target = target.parent_path() / std::filesystem::read_symlink(target, unknown);
  return target.string();
}

// Renaming over a device or a pipe would remove it.
std::string replaceable(const std::string& path) {
  std::string target = link_target(path);
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);  // The target of /dev/stdout may be no path.
  if (std::filesystem::is_symlink(target, unknown)) fail_to_write(path, ELOOP);
  if (std::filesystem::is_directory(status)) fail_to_write(path, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw Failure(ExitCode::cannot_access, path + ": cannot be written: is a device or a pipe");
  return target;
}

constexpr int kPartsMax = 100;

std::string part_path(const std::string& target, int number) {
  const std::filesystem::path path(target);
  std::string name = ".";
  name += path.filename().string();
  if (number > 1) name.append(".").append(std::to_string(number));
  return (path.parent_path() / name.append(".part")).string();
}

// This kind of lock belongs to the open file, so that it also separates two writers in one process. It is
// independent of the other kind, which HDF5 takes, and ends with its process.
bool lock(int descriptor, int how) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return fcntl(descriptor, how, &whole) == 0;
}

bool is_still_at(int descriptor, const std::string& path) {
  struct stat open_file {};
  struct stat named {};
  return fstat(descriptor, &open_file) == 0 && lstat(path.c_str(), &named) == 0 &&
         open_file.st_ino == named.st_ino && open_file.st_dev == named.st_dev;
}

// Only the holder of the lock removes the file, and only while it still has its name.
void remove_if_abandoned(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (lock(descriptor, F_OFD_SETLK) && is_still_at(descriptor, path)) unlink(path.c_str());
  close(descriptor);
}

// Creates a file of that name, locked; -1 if one exists already.
int create_part(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return -1;
  lock(descriptor, F_OFD_SETLKW);  // Some file systems have no locks; there no part file is removed.
  if (is_still_at(descriptor, path)) return descriptor;
  close(descriptor);  // Another writer removed it before it was locked.
  errno = EEXIST;
  return -1;
}

// Sets the path of the part file; its lock lives as long as the descriptor is open.
int create_part_file(const std::string& target, std::string& path) {
  for (int number = 1; number <= kPartsMax; ++number) {
    path = part_path(target, number);
    int descriptor = create_part(path);
    if (descriptor < 0 && errno == EEXIST) {
      remove_if_abandoned(path);
      descriptor = create_part(path);
    }
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) fail_to_write(target, errno);
  }
  throw Failure(ExitCode::cannot_access, target + ": cannot be written: " + std::to_string(kPartsMax) +
                                             " others are writing it; if none is, remove the files " +
                                             part_path(target, 1) + ", .2.part and so on");
}

// Gives an open file the mode of the file that it will replace, if there is one, and these bits more: who may
// not read the old file may not read the new one, nor while it is written.
void take_mode(int descriptor, const std::string& replaced, unsigned more) {
  struct stat state {};
  if (stat(replaced.c_str(), &state) == 0) fchmod(descriptor, (state.st_mode & 0777) | more);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(replaceable(path)) {
  const SignalsHeld held;
  lock_ = create_part_file(path_, part_path_);
  remove_on_signal(part_path_);
  take_mode(lock_, path_, S_IRUSR | S_IWUSR);
}

AtomicFile::~AtomicFile() {
  if (!part_path_.empty()) unlink(part_path_.c_str());
  keep_on_signal(part_path_);
  close(lock_);
}

const std::string& AtomicFile::part_path() { return part_path_; }

void AtomicFile::write(std::string_view text) const {
  std::FILE* const file = std::fopen(part_path_.c_str(), "wb");
  if (file == nullptr) fail_to_write(path_, errno);
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !is_written) fail_to_write(path_, errno);
}

void AtomicFile::commit() {
  take_mode(lock_, path_, 0);
  if (std::rename(part_path_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
  keep_on_signal(part_path_);
  part_path_.clear();
}

// Creating a link never replaces a file. On a file system without links, a file that another program creates
// at the same moment is replaced.
void AtomicFile::commit_as_new() {
  if (link(part_path_.c_str(), path_.c_str()) == 0) return;
  if (errno == EEXIST || is_there(path_)) fail_to_write(path_, EEXIST);
  commit();
}

}  // namespace hyrax

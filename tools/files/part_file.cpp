#include "tools/files/part_file.h"

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

constexpr int kPartsMax = 100;

std::string part_path(const std::string& target, int number) {
  const std::filesystem::path path(target);
  std::string name = ".";
  name += path.filename().string();
  if (number > 1) name.append(".").append(std::to_string(number));
  return (path.parent_path() / name.append(".part")).string();
}

// A lock of this kind is of the open file, so that two writers in one process are kept apart as well;
// it does not meet the other kind, which HDF5 takes. It ends with its process.
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

// Who holds the lock of a file that still has its name is its only owner: nobody else removes it.
void remove_if_abandoned(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (lock(descriptor, F_OFD_SETLK) && is_still_at(descriptor, path)) unlink(path.c_str());
  close(descriptor);
}

// A new file of that name, locked; -1 where there is one already.
int make(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return -1;
  lock(descriptor, F_OFD_SETLKW);  // Some file systems know no locks: there nothing is taken for abandoned.
  if (is_still_at(descriptor, path)) return descriptor;
  close(descriptor);  // Someone took it for abandoned before it was locked.
  errno = EEXIST;
  return -1;
}

}  // namespace

PartFile make_part_file(const std::string& target) {
  for (int number = 1; number <= kPartsMax; ++number) {
    PartFile part{part_path(target, number), -1};
    part.descriptor = make(part.path);
    if (part.descriptor < 0 && errno == EEXIST) {
      remove_if_abandoned(part.path);
      part.descriptor = make(part.path);
    }
    if (part.descriptor >= 0) return part;
    if (errno != EEXIST) fail_to_write(target, errno);
  }
  throw Failure(ExitCode::cannot_access, target + ": cannot be written: " + std::to_string(kPartsMax) +
                                             " others are writing it; where none is, remove the files " +
                                             part_path(target, 1) + ", .2.part and so on");
}

}  // namespace hyrax

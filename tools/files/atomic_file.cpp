#include "tools/files/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "tools/files/failure.h"

namespace hyrax {
namespace {

std::string behind_links(const std::string& path) {
  std::error_code error;
  const auto target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

// mkstemp makes files for the owner alone; this one is to be as any other new file.
void set_usual_mode(int descriptor) {
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(behind_links(path)) {
  if (std::filesystem::is_directory(path_)) fail_to_write(path, EISDIR);
  const std::filesystem::path target(path_);
  part_path_ = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX.part")).string();
  const int descriptor = mkstemps(part_path_.data(), 5);
  if (descriptor < 0) fail_to_write(path, errno);
  set_usual_mode(descriptor);
  close(descriptor);
}

AtomicFile::~AtomicFile() {
  if (!part_path_.empty()) unlink(part_path_.c_str());
}

void AtomicFile::write(std::string_view text) const {
  std::FILE* const file = std::fopen(part_path_.c_str(), "wb");
  if (file == nullptr) fail_to_write(path_, errno);
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !is_written) fail_to_write(path_, errno);
}

void AtomicFile::commit() {
  if (std::rename(part_path_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
  part_path_.clear();
}

void fail_to_write(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: " + std::strerror(error_number));
}

}  // namespace hyrax

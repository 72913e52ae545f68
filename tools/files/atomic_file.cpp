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

// Also of a link whose target is not there yet.
std::string behind_links(const std::string& path) {
  constexpr int kLinksMax = 40;
  std::error_code unknown;
  std::filesystem::path target = path;
  for (int links = 0; links < kLinksMax && std::filesystem::is_symlink(target, unknown); ++links)
    target = target.parent_path() / std::filesystem::read_symlink(target, unknown);
  return target.string();
}

// To rename over a device or a pipe would take it away from everyone.
void refuse_what_is_no_file(const std::string& target, const std::string& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(target, unknown);
  if (std::filesystem::is_directory(status)) fail_to_write(path, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw Failure(ExitCode::cannot_access,
                  path + ": cannot be written: it is no file but a device or a pipe");
}

// mkstemp makes files for the owner alone; this one is to be as any other new file.
void set_usual_mode(int descriptor) {
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(behind_links(path)) {
  refuse_what_is_no_file(path_, path);
  const std::filesystem::path target(path_);
  std::string part = ".";
  part += target.filename().string() + ".XXXXXX.part";
  part_path_ = (target.parent_path() / part).string();
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

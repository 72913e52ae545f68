#include "tools/files/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/files/part_file.h"
#include "tools/files/presence.h"

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
std::string replaceable(const std::string& path) {
  std::string target = behind_links(path);
  std::error_code unknown;
  const auto status = std::filesystem::status(target, unknown);
  if (std::filesystem::is_symlink(target, unknown)) fail_to_write(path, ELOOP);
  if (std::filesystem::is_directory(status)) fail_to_write(path, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw Failure(ExitCode::cannot_access,
                  path + ": cannot be written: it is no file but a device or a pipe");
  return target;
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(replaceable(path)) {
  PartFile part = make_part_file(path_);
  part_path_ = std::move(part.path);
  lock_ = part.descriptor;
}

AtomicFile::~AtomicFile() {
  if (!part_path_.empty()) unlink(part_path_.c_str());
  close(lock_);
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

// A link never replaces a file. Where the file system has no links, a file that another program makes in
// the same moment is not noticed.
void AtomicFile::commit_as_new() {
  if (link(part_path_.c_str(), path_.c_str()) == 0) return;
  if (errno == EEXIST || is_there(path_)) fail_to_write(path_, EEXIST);
  commit();
}

void fail_to_write(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: " + std::strerror(error_number));
}

}  // namespace hyrax

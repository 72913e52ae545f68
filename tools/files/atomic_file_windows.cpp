#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <process.h>
#include <windows.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"

namespace hyrax {

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) fail_to_write(path, EISDIR);
  const std::filesystem::path target(path);
  std::string part = ".";
  part += target.filename().string() + "." + std::to_string(_getpid()) + ".part";
  part_path_ = (target.parent_path() / part).string();
  std::FILE* const file = std::fopen(part_path_.c_str(), "wb");
  if (file == nullptr) fail_to_write(path, errno);
  std::fclose(file);
}

AtomicFile::~AtomicFile() {
  if (!part_path_.empty()) std::remove(part_path_.c_str());
}

void AtomicFile::write(std::string_view text) const {
  std::FILE* const file = std::fopen(part_path_.c_str(), "wb");
  if (file == nullptr) fail_to_write(path_, errno);
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !is_written) fail_to_write(path_, errno);
}

void AtomicFile::commit() {
  const std::wstring from = std::filesystem::path(part_path_).wstring();
  const std::wstring to = std::filesystem::path(path_).wstring();
  if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0)
    throw Failure(
        ExitCode::cannot_access,
        path_ + ": cannot be written: " + std::system_category().message(static_cast<int>(GetLastError())));
  part_path_.clear();
}

void fail_to_write(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be written: " + std::strerror(error_number));
}

}  // namespace hyrax

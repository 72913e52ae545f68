#include <cerrno>
#include <cstdio>
#include <system_error>

#include <io.h>
#include <process.h>
#include <windows.h>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

// While another program, such as a virus scanner, reads the old file, it cannot be replaced.
bool rename_to(const std::string& from, const std::string& to, DWORD how) {
  constexpr int kTries = 20;
  constexpr DWORD kPause_ms = 10;
  for (int tries = 1;; ++tries) {
    if (MoveFileExA(from.c_str(), to.c_str(), how | MOVEFILE_WRITE_THROUGH) != 0) return true;
    const DWORD error = GetLastError();
    const bool may_pass = error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED;
    if (!may_pass || tries == kTries) return false;
    Sleep(kPause_ms);
  }
}

[[noreturn]] void fail_to_move(const std::string& path) {
  const auto error = static_cast<int>(GetLastError());
  throw Failure(ExitCode::cannot_access,
                path + ": cannot be written: " + std::system_category().message(error));
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  const DWORD attributes = GetFileAttributesA(path.c_str());
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
    fail_to_write(path, EISDIR);
  const FileName name = file_name(path);
  part_path_.append(name.folder).append(".").append(name.stem).append(name.extension);
  part_path_.append(".").append(std::to_string(_getpid())).append(".part");
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
  // On the disk before the rename, so that a power cut leaves the old file or the new one.
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                          std::fflush(file) == 0 && _commit(_fileno(file)) == 0;
  if (std::fclose(file) != 0 || !is_written) fail_to_write(path_, errno);
}

void AtomicFile::commit() {
  if (!rename_to(part_path_, path_, MOVEFILE_REPLACE_EXISTING)) fail_to_move(path_);
  part_path_.clear();
}

void AtomicFile::commit_as_new() {
  if (!rename_to(part_path_, path_, 0)) fail_to_move(path_);
  part_path_.clear();
}

}  // namespace hyrax

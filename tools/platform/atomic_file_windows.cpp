#include "tools/platform/atomic_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <process.h>
#include <windows.h>

#include "tools/files/failure.h"
#include "tools/platform/path.h"
#include "tools/platform/wide_text.h"

namespace hyrax {
namespace {

[[noreturn]] void fail(const std::string& path) {
  const auto error = static_cast<int>(GetLastError());
  throw Failure(ExitCode::cannot_access,
                path + ": cannot be written: " + std::system_category().message(error));
}

// A file that is to be removed goes when its last handle is closed, also by the end of a killed process.
bool set_removal(HANDLE file, bool is_removed) {
  FILE_DISPOSITION_INFO disposition{};
  disposition.DeleteFile = is_removed;
  return SetFileInformationByHandle(file, FileDispositionInfo, &disposition, sizeof disposition) != 0;
}

// While another program, such as a virus scanner, reads the old file, it cannot be replaced.
void rename_to(const std::string& from, const std::string& to, DWORD how) {
  constexpr int kTries = 20;
  constexpr DWORD kPause_ms = 10;
  for (int tries = 1;; ++tries) {
    if (MoveFileExW(system_path(from).c_str(), system_path(to).c_str(), how | MOVEFILE_WRITE_THROUGH) != 0)
      return;
    const DWORD error = GetLastError();
    const bool may_pass = error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED;
    if (!may_pass || tries == kTries) fail(to);
    Sleep(kPause_ms);
  }
}

// It stays when it is closed, which comes first: nobody else can write to it or rename it before.
void close(HANDLE& file, const std::string& path) {
  if (file == nullptr) return;
  if (!set_removal(file, false)) fail(path);
  CloseHandle(std::exchange(file, nullptr));
}

void finish(HANDLE& file, std::string& part_path, const std::string& path, DWORD how) {
  close(file, path);
  rename_to(part_path, path, how);
  part_path.clear();
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  if (is_folder(path)) fail_to_write(path, EISDIR);
  const FileName name = file_name(path);
  part_path_.append(name.folder).append(".").append(name.stem).append(name.extension);
  part_path_.append(".").append(std::to_string(_getpid())).append(".part");
  file_ = CreateFileW(system_path(part_path_).c_str(), GENERIC_WRITE | DELETE, FILE_SHARE_READ, nullptr,
                      CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file_ == INVALID_HANDLE_VALUE) fail(path);  // No destructor follows.
  set_removal(file_, true);
}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr) CloseHandle(file_);
  if (!part_path_.empty()) remove_file(part_path_);
}

const std::string& AtomicFile::part_path() {
  close(file_, path_);
  return part_path_;
}

void AtomicFile::write(std::string_view text) const {
  DWORD written = 0;
  // On the disk before the rename, so that a power cut leaves the old file or the new one.
  if (WriteFile(file_, text.data(), static_cast<DWORD>(text.size()), &written, nullptr) == 0 ||
      FlushFileBuffers(file_) == 0)
    fail(path_);
}

void AtomicFile::commit() { finish(file_, part_path_, path_, MOVEFILE_REPLACE_EXISTING); }

void AtomicFile::commit_as_new() { finish(file_, part_path_, path_, 0); }

}  // namespace hyrax

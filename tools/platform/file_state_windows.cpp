#include "tools/platform/file_state.h"

#include <cerrno>

#include <io.h>
#include <windows.h>

#include "tools/platform/wide_text.h"

namespace hyrax {
namespace {

constexpr int kForReading = 4;
constexpr int kForWriting = 2;

int error_of(const std::string& path, int use) {
  return _waccess(system_path(path).c_str(), use) == 0 ? 0 : errno;
}

}  // namespace

int error_of_reading(const std::string& path) { return error_of(path, kForReading); }

// Who may write there is known when it is tried.
int error_of_writing_in(const std::string& folder) { return error_of(folder, kForWriting); }

int error_of_removing(const std::string& path) {
  return _wunlink(system_path(path).c_str()) == 0 || errno == ENOENT ? 0 : errno;
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> identity_of(const std::string& path) {
  const HANDLE file =
      CreateFileW(system_path(path).c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                  nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) return std::nullopt;
  BY_HANDLE_FILE_INFORMATION found{};
  const bool is_known = GetFileInformationByHandle(file, &found) != 0;
  CloseHandle(file);
  if (!is_known) return std::nullopt;
  return std::pair{std::uint64_t{found.dwVolumeSerialNumber},
                   std::uint64_t{found.nFileIndexHigh} << 32 | found.nFileIndexLow};
}

// Who writes a file there has it open so that no other can open it at all.
bool is_locked(const std::string& /*path*/) { return false; }

}  // namespace hyrax

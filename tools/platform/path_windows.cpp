#include "tools/platform/path.h"

#include <io.h>
#include <windows.h>

#include "tools/platform/wide_text.h"

namespace hyrax {
namespace {

constexpr std::string_view kStandardInput = "/dev/stdin";

// Of no file: all bits.
DWORD attributes_of(const std::string& path) { return GetFileAttributesW(system_path(path).c_str()); }

}  // namespace

std::wstring to_wide(std::string_view utf8) {
  const int size = static_cast<int>(utf8.size());
  std::wstring wide(static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, utf8.data(), size, nullptr, 0)),
                    0);
  MultiByteToWideChar(CP_UTF8, 0, utf8.data(), size, wide.data(), static_cast<int>(wide.size()));
  return wide;
}

std::string to_utf8(std::wstring_view wide) {
  const int size = static_cast<int>(wide.size());
  const int length = WideCharToMultiByte(CP_UTF8, 0, wide.data(), size, nullptr, 0, nullptr, nullptr);
  std::string utf8(static_cast<std::size_t>(length), 0);
  WideCharToMultiByte(CP_UTF8, 0, wide.data(), size, utf8.data(), length, nullptr, nullptr);
  return utf8;
}

std::wstring system_path(const std::string& path) {
  constexpr DWORD kLong = MAX_PATH - 12;  // A folder's name must leave room for that of a file.
  const std::wstring wide = to_wide(path);
  const DWORD size = GetFullPathNameW(wide.c_str(), 0, nullptr, nullptr);
  if (size < kLong || wide.starts_with(L"\\\\?")) return wide;
  std::wstring full(size, 0);
  full.resize(GetFullPathNameW(wide.c_str(), size, full.data(), nullptr));
  return full.starts_with(L"\\\\") ? L"\\\\?\\UNC" + full.substr(1) : L"\\\\?\\" + full;
}

std::string_view path_separators() { return "/\\:"; }

std::FILE* open_file(const std::string& path, const char* mode) {
  if (path == kStandardInput) return _fdopen(_dup(_fileno(stdin)), mode);
  return _wfopen(system_path(path).c_str(), to_wide(mode).c_str());
}

void remove_file(const std::string& path) { DeleteFileW(system_path(path).c_str()); }

bool is_there(const std::string& path) {
  if (path == kStandardInput || attributes_of(path) != INVALID_FILE_ATTRIBUTES) return true;
  const DWORD error = GetLastError();
  return error != ERROR_FILE_NOT_FOUND && error != ERROR_PATH_NOT_FOUND && error != ERROR_INVALID_NAME;
}

bool is_folder(const std::string& path) {
  return attributes_of(path) != INVALID_FILE_ATTRIBUTES &&
         (attributes_of(path) & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

bool is_regular_file(const std::string& path) {
  return (attributes_of(path) & FILE_ATTRIBUTE_DIRECTORY) == 0;
}

bool is_device_or_pipe(const std::string&) { return false; }  // Those of Windows can be read to an end.

}  // namespace hyrax

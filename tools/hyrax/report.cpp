#include "tools/hyrax/report.h"

#include <windows.h>

namespace hyrax {
namespace {

bool is_good(HANDLE handle) { return handle != nullptr && handle != INVALID_HANDLE_VALUE; }

// A program with windows starts without a console; it may use that of its parent.
HANDLE output(DWORD which) {
  const HANDLE given = GetStdHandle(which);
  if (is_good(given)) return given;
  if (AttachConsole(ATTACH_PARENT_PROCESS) == 0 && GetLastError() != ERROR_ACCESS_DENIED) return nullptr;
  return CreateFileW(L"CONOUT$", GENERIC_WRITE, FILE_SHARE_WRITE, nullptr, OPEN_EXISTING, 0, nullptr);
}

void report_on(DWORD which, std::string_view text, UINT icon) {
  std::string line(text);
  if (!line.ends_with('\n')) line += '\n';
  DWORD written = 0;
  const HANDLE handle = output(which);
  if (is_good(handle) &&
      WriteFile(handle, line.data(), static_cast<DWORD>(line.size()), &written, nullptr) != 0)
    return;
  MessageBoxW(nullptr, to_wide(text).c_str(), L"Hyrax", MB_OK | MB_SETFOREGROUND | icon);
}

}  // namespace

void report(std::string_view text) { report_on(STD_OUTPUT_HANDLE, text, MB_ICONINFORMATION); }

void report_error(std::string_view text) { report_on(STD_ERROR_HANDLE, text, MB_ICONERROR); }

void report(const PlaybackVerdict& verdict) {
  verdict.exit_code == ExitCode::agreed ? report(verdict.sentence) : report_error(verdict.sentence);
}

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

}  // namespace hyrax

#include "tools/hyrax/report.h"

#include <windows.h>

#include "tools/platform/wide_text.h"

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

}  // namespace hyrax

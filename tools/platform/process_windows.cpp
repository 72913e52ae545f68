#include "tools/platform/process.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <windows.h>

#include "tools/platform/wide_text.h"

namespace hyrax {

// A file that cannot grow is an error.
void prepare_signals() {}

// The C library's own limit; the system has none.
void allow_open_files(std::size_t count) {
  constexpr std::size_t kOthers = 64;
  constexpr std::size_t kMost = 8192;
  if (count + kOthers > static_cast<std::size_t>(_getmaxstdio()))
    _setmaxstdio(static_cast<int>(std::min(count + kOthers, kMost)));
}

std::optional<std::uint64_t> address_space_bytes_max() { return std::nullopt; }

std::int64_t thread_time_ns() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

std::string processor_name() {
  wchar_t name[128] = {};
  DWORD bytes = sizeof name;
  const LSTATUS status =
      RegGetValueW(HKEY_LOCAL_MACHINE, L"HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0",
                   L"ProcessorNameString", RRF_RT_REG_SZ, nullptr, name, &bytes);
  return status == ERROR_SUCCESS ? to_utf8(name) : "unknown processor";
}

std::string cache_folder() {
  const wchar_t* const folder = _wgetenv(L"LOCALAPPDATA");
  return folder == nullptr ? "" : to_utf8(folder);
}

}  // namespace hyrax

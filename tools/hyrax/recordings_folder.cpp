#include <shlobj.h>

#include "tools/hyrax/window.h"
#include "tools/platform/wide_text.h"
#include "tools/recorder/recording.h"

namespace hyrax {
namespace {

// "Documents\Hyrax", created if needed; the current folder if the user has no documents.
std::wstring recordings_folder() {
  PWSTR documents = nullptr;
  if (FAILED(SHGetKnownFolderPath(FOLDERID_Documents, 0, nullptr, &documents))) return L".";
  const std::wstring folder = std::wstring(documents) + L"\\Hyrax";
  CoTaskMemFree(documents);
  CreateDirectoryW(folder.c_str(), nullptr);
  return folder;
}

}  // namespace

std::string new_recording_path(const std::string& name) {
  SYSTEMTIME time{};
  GetLocalTime(&time);
  wchar_t stamp[32];
  wsprintfW(stamp, L"-%04d%02d%02d-%02d%02d%02d.json", time.wYear, time.wMonth, time.wDay, time.wHour,
            time.wMinute, time.wSecond);
  return free_path(to_utf8(recordings_folder() + L"\\" + to_wide(name) + stamp));
}

}  // namespace hyrax

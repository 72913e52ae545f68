#include "tools/hyrax/tray_icon.h"

#include <shellapi.h>

#include "tools/hyrax/report.h"
#include "tools/hyrax/resource_ids.h"

namespace hyrax {
namespace {

NOTIFYICONDATAW data_of(HWND window) {
  NOTIFYICONDATAW data{};
  data.cbSize = sizeof data;
  data.hWnd = window;
  data.uID = 1;
  return data;
}

template <std::size_t N>
void copy(wchar_t (&target)[N], const std::wstring& text) {
  lstrcpynW(target, text.c_str(), static_cast<int>(N));
}

}  // namespace

TrayIcon::TrayIcon(HWND window, UINT message) : window_(window), message_(message) { show(); }

TrayIcon::~TrayIcon() {
  NOTIFYICONDATAW data = data_of(window_);
  Shell_NotifyIconW(NIM_DELETE, &data);
}

void TrayIcon::show() const {
  NOTIFYICONDATAW data = data_of(window_);
  data.uFlags = NIF_MESSAGE | NIF_ICON | NIF_TIP;
  data.uCallbackMessage = message_;
  data.hIcon =
      static_cast<HICON>(LoadImageW(GetModuleHandleW(nullptr), MAKEINTRESOURCEW(HYRAX_ICON), IMAGE_ICON,
                                    GetSystemMetrics(SM_CXSMICON), GetSystemMetrics(SM_CYSMICON), LR_SHARED));
  copy(data.szTip, L"Hyrax");
  Shell_NotifyIconW(NIM_ADD, &data);
}

void TrayIcon::tell(const std::string& sentence) const {
  NOTIFYICONDATAW data = data_of(window_);
  data.uFlags = NIF_INFO;
  data.dwInfoFlags = NIIF_USER;
  copy(data.szInfoTitle, L"Hyrax");
  copy(data.szInfo, to_wide(sentence));
  Shell_NotifyIconW(NIM_MODIFY, &data);
}

}  // namespace hyrax

#include "tools/hyrax/window.h"

#include <shellapi.h>

#include "tools/files/build_info.h"
#include "tools/hyrax/resource_ids.h"
#include "tools/platform/wide_text.h"

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

void TrayIcon::notify(const std::string& sentence) const {
  NOTIFYICONDATAW data = data_of(window_);
  data.uFlags = NIF_INFO;
  data.dwInfoFlags = NIIF_USER;
  copy(data.szInfoTitle, L"Hyrax");
  copy(data.szInfo, to_wide(sentence));
  Shell_NotifyIconW(NIM_MODIFY, &data);
}

Choice choose_from_menu(HWND window, const std::vector<MenuEntry>& entries) {
  const HMENU menu = CreatePopupMenu();
  for (const MenuEntry& entry : entries) {
    const UINT kind = entry.choice == Choice::none ? MF_SEPARATOR : MF_STRING;
    AppendMenuW(menu, kind | (entry.is_enabled ? MF_ENABLED : MF_GRAYED), static_cast<UINT_PTR>(entry.choice),
                to_wide(entry.text).c_str());
  }
  POINT pointer{};
  GetCursorPos(&pointer);
  const HWND active = GetForegroundWindow();
  SetForegroundWindow(window);  // Otherwise the menu stays open when the user clicks elsewhere.
  const BOOL chosen = TrackPopupMenuEx(menu, TPM_RETURNCMD | TPM_NONOTIFY | TPM_RIGHTBUTTON, pointer.x,
                                       pointer.y, window, nullptr);
  DestroyMenu(menu);
  if (active != nullptr) SetForegroundWindow(active);  // The keyboard returns to the window that had it.
  return static_cast<Choice>(chosen);
}

void show_about() {
  const std::string text = "Hyrax " + std::string(build_info().version) +
                           "\n\nGrab it, drag it, let go.\n"
                           "What you record, hyrax-sim replays to the bit.";
  MessageBoxW(nullptr, to_wide(text).c_str(), L"About Hyrax", MB_OK | MB_SETFOREGROUND | MB_ICONINFORMATION);
}

}  // namespace hyrax

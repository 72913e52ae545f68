// The icon beside the clock.
#pragma once

#include <string>

#include <windows.h>

namespace hyrax {

class TrayIcon {
 public:
  /// @param message that the window gets when something is done to the icon.
  TrayIcon(HWND window, UINT message);
  TrayIcon(const TrayIcon&) = delete;
  TrayIcon& operator=(const TrayIcon&) = delete;
  ~TrayIcon();

  /// Puts it there, again after the task bar was started anew.
  void show() const;
  /// Shows a sentence beside it for a while.
  void tell(const std::string& sentence) const;

 private:
  HWND window_;
  UINT message_;
};

}  // namespace hyrax

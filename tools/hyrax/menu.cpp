#include "tools/hyrax/menu.h"

namespace hyrax {
namespace {

void add(HMENU menu, Choice choice, const wchar_t* text, bool is_enabled = true) {
  AppendMenuW(menu, MF_STRING | (is_enabled ? MF_ENABLED : MF_GRAYED), static_cast<UINT_PTR>(choice), text);
}

void add_line(HMENU menu) { AppendMenuW(menu, MF_SEPARATOR, 0, nullptr); }

}  // namespace

Choice choose_from_menu(HWND window, const MenuState& state) {
  const HMENU menu = CreatePopupMenu();
  const bool is_live = !state.is_replay;
  add(menu, Choice::throw_it, L"&Throw", is_live);
  add(menu, Choice::pause, state.is_paused ? L"&Go on" : L"&Pause", is_live);
  add(menu, Choice::reset, L"&Reset", is_live);
  add_line(menu);
  add(menu, Choice::start_recording, L"Start re&cording", is_live && !state.is_recording);
  add(menu, Choice::save_recording, L"&Save recording", is_live && state.is_recording);
  add(menu, Choice::save_just_happened, L"Save what &just happened", is_live);
  add_line(menu);
  add(menu, Choice::about, L"&About Hyrax");
  add(menu, Choice::quit, L"&Quit");
  POINT pointer{};
  GetCursorPos(&pointer);
  const HWND active = GetForegroundWindow();
  SetForegroundWindow(window);  // Else the menu stays when the user clicks beside it.
  const BOOL chosen = TrackPopupMenuEx(menu, TPM_RETURNCMD | TPM_NONOTIFY | TPM_RIGHTBUTTON, pointer.x,
                                       pointer.y, window, nullptr);
  DestroyMenu(menu);
  if (active != nullptr) SetForegroundWindow(active);  // The user goes on typing where it was.
  return static_cast<Choice>(chosen);
}

}  // namespace hyrax

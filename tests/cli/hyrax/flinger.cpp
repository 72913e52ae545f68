// Mouse, keyboard and display for tests of hyrax.exe under Wine. Performs the actions of its
// command line in order.
//
//   flinger ACTION [NUMBER]...
//
//   find SECONDS          waits until the hyrax has a window, which all other actions use
//   point X Y             moves the mouse to X, Y from the window's top left corner
//   by DX DY TIMES MS     moves the mouse TIMES times by DX, DY, and waits MS before each
//   grab, release         the left button
//   right                 a click of the right button
//   key CODE              presses and releases a key
//   post MESSAGE WORD LONG  posts a message to the window
//   sleep MS
//   display WIDTH HEIGHT  changes the size of the display
//
// Exit codes: 0 done, 1 something could not be done, 2 the command line is wrong.
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <string_view>

namespace {

constexpr const wchar_t* kWindowClass = L"hyrax";

[[noreturn]] void stop(int code, const char* sentence) {
  std::fprintf(stderr, "flinger: %s (error %lu)\n", sentence, GetLastError());
  std::exit(code);
}

HWND find(DWORD wait_ms) {
  const ULONGLONG end = GetTickCount64() + wait_ms;
  do {
    const HWND window = FindWindowW(kWindowClass, nullptr);
    if (window != nullptr && IsWindowVisible(window)) return window;
    Sleep(20);
  } while (GetTickCount64() < end);
  stop(1, "there is no hyrax");
}

RECT place_of(HWND window) {
  RECT rect{};
  if (!GetWindowRect(window, &rect)) stop(1, "the window is gone");
  return rect;
}

void send_mouse(DWORD flags, LONG x = 0, LONG y = 0) {
  INPUT input{};
  input.type = INPUT_MOUSE;
  input.mi.dwFlags = flags;
  input.mi.dx = x;
  input.mi.dy = y;
  if (SendInput(1, &input, sizeof input) != 1) stop(1, "SendInput failed");
}

// Windows reads points as 65,536ths of the screen and rounds down.
void move_to(POINT to) {
  const LONG width = GetSystemMetrics(SM_CXSCREEN);
  const LONG height = GetSystemMetrics(SM_CYSCREEN);
  send_mouse(MOUSEEVENTF_MOVE | MOUSEEVENTF_ABSOLUTE, (to.x * 65536 + width - 1) / width,
             (to.y * 65536 + height - 1) / height);
}

void send_key(WORD code) {
  INPUT inputs[2] = {};
  for (INPUT& input : inputs) {
    input.type = INPUT_KEYBOARD;
    input.ki.wVk = code;
  }
  inputs[1].ki.dwFlags = KEYEVENTF_KEYUP;
  if (SendInput(2, inputs, sizeof inputs[0]) != 2) stop(1, "SendInput failed");
}

void change_display(DWORD width, DWORD height) {
  DEVMODEW mode{};
  mode.dmSize = sizeof mode;
  mode.dmFields = DM_PELSWIDTH | DM_PELSHEIGHT;
  mode.dmPelsWidth = width;
  mode.dmPelsHeight = height;
  if (ChangeDisplaySettingsExW(nullptr, &mode, nullptr, 0, nullptr) != DISP_CHANGE_SUCCESSFUL)
    stop(1, "the display has no such size");
}

struct Hand {
  HWND window = nullptr;
  POINT mouse{};

  // From the window's top left corner.
  void point(LONG x, LONG y) {
    const RECT rect = place_of(window);
    mouse = {rect.left + x, rect.top + y};
    move_to(mouse);
  }
  void move_by(LONG dx, LONG dy, LONG times, DWORD wait_ms) {
    for (LONG i = 0; i < times; ++i) {
      Sleep(wait_ms);
      mouse = {mouse.x + dx, mouse.y + dy};
      move_to(mouse);
    }
  }
};

struct Act {
  std::wstring_view name;
  std::size_t numbers;
  void (*act)(Hand& hand, const long* number);
};

constexpr Act kActs[] = {
    {L"find", 1, [](Hand& hand, const long* n) { hand.window = find(static_cast<DWORD>(n[0]) * 1000); }},
    {L"point", 2, [](Hand& hand, const long* n) { hand.point(n[0], n[1]); }},
    {L"by", 4, [](Hand& hand, const long* n) { hand.move_by(n[0], n[1], n[2], static_cast<DWORD>(n[3])); }},
    {L"grab", 0, [](Hand&, const long*) { send_mouse(MOUSEEVENTF_LEFTDOWN); }},
    {L"release", 0, [](Hand&, const long*) { send_mouse(MOUSEEVENTF_LEFTUP); }},
    {L"right", 0,
     [](Hand&, const long*) {
       send_mouse(MOUSEEVENTF_RIGHTDOWN);
       send_mouse(MOUSEEVENTF_RIGHTUP);
     }},
    {L"key", 1, [](Hand&, const long* n) { send_key(static_cast<WORD>(n[0])); }},
    {L"post", 3,
     [](Hand& hand, const long* n) {
       if (!PostMessageW(hand.window, static_cast<UINT>(n[0]), static_cast<WPARAM>(n[1]), n[2]))
         stop(1, "the window is gone");
     }},
    {L"sleep", 1, [](Hand&, const long* n) { Sleep(static_cast<DWORD>(n[0])); }},
    {L"display", 2,
     [](Hand&, const long* n) { change_display(static_cast<DWORD>(n[0]), static_cast<DWORD>(n[1])); }},
};
constexpr std::size_t kNumbersMax = 4;

const Act& act_of(std::wstring_view name) {
  for (const Act& act : kActs)
    if (act.name == name) return act;
  stop(2, "unknown action");
}

long number_of(const wchar_t* text) {
  wchar_t* end = nullptr;
  const long value = std::wcstol(text, &end, 0);
  if (end == text || *end != L'\0') stop(2, "a number is expected");
  return value;
}

}  // namespace

int wmain(int count, wchar_t** arguments) {
  Hand hand;
  for (int at = 1; at < count;) {
    const Act& act = act_of(arguments[at++]);
    long numbers[kNumbersMax] = {};
    for (std::size_t i = 0; i < act.numbers; ++i) {
      if (at == count) stop(2, "the command line ends too early");
      numbers[i] = number_of(arguments[at++]);
    }
    act.act(hand, numbers);
  }
  return 0;
}

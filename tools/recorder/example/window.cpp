// A box in a window, thrown with the mouse. What happens is recorded.
#include <windows.h>

#include "elastic_box.h"
#include "tools/recorder/physics_recorder.h"

int main() {
  constexpr int kSide = 64;
  const WNDCLASSW kind{.lpfnWndProc = DefWindowProcW, .lpszClassName = L"hyrax"};
  RegisterClassW(&kind);
  const HWND window = CreateWindowW(kind.lpszClassName, L"Throw me", WS_OVERLAPPEDWINDOW | WS_VISIBLE, 50, 50,
                                    640, 480, nullptr, nullptr, nullptr, nullptr);
  physics box(100, 100, 200, 100);
  hyrax::PhysicsRecorder recorder("my-fling.json", box, {640, 480}, {kSide, kSide});
  POINT hand{};
  RECT area{};
  MSG message{};
  for (auto last = std::chrono::steady_clock::now();; Sleep(10)) {
    while (PeekMessageW(&message, nullptr, 0, 0, PM_REMOVE)) DispatchMessageW(&message);
    if (!GetClientRect(window, &area)) return 0;  // It is closed; the recorder's end joins its parts.
    const auto now = std::chrono::steady_clock::now();
    const double dt_s = std::chrono::duration<double>(now - std::exchange(last, now)).count();
    const POINT before = hand;
    GetCursorPos(&hand);
    ScreenToClient(window, &hand);
    if (GetAsyncKeyState(VK_LBUTTON) < 0) {
      box.setPos(hand.x - kSide / 2, hand.y - kSide / 2);
      box.setVelocity((hand.x - before.x) / dt_s, (hand.y - before.y) / dt_s);
      recorder.hold(box, dt_s, area.right, area.bottom, kSide, kSide);
    } else {
      recorder.update(box, dt_s, area.right, area.bottom, kSide, kSide);  // box.update
    }
    const HDC canvas = GetDC(window);
    FillRect(canvas, &area, GetSysColorBrush(COLOR_WINDOW));
    Rectangle(canvas, int(box.x()), int(box.y()), int(box.x()) + kSide, int(box.y()) + kSide);
    ReleaseDC(window, canvas);
  }
}

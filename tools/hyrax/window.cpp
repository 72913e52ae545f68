#include "tools/hyrax/window.h"

#include <objidl.h>

#include <algorithm>
#include <memory>
using std::max;
using std::min;
#include <gdiplus.h>

#include "tools/files/failure.h"
#include "tools/hyrax/resource_ids.h"

namespace hyrax {
namespace {

constexpr int kSideMax_px = 2048;  // Of the picture; a scenario's sprite may be larger.

[[noreturn]] void fail_to_draw(const std::string& what) {
  throw Failure(ExitCode::program_fault, "hyrax: the sprite cannot be drawn: " + what);
}

std::unique_ptr<Gdiplus::Bitmap> load(int resource) {
  const HRSRC found = FindResourceW(nullptr, MAKEINTRESOURCEW(resource), MAKEINTRESOURCEW(10));  // RT_RCDATA
  if (found == nullptr) fail_to_draw("resource " + std::to_string(resource) + " is missing");
  const DWORD size = SizeofResource(nullptr, found);
  const HGLOBAL memory = GlobalAlloc(GMEM_MOVEABLE, size);
  if (memory == nullptr) fail_to_draw("out of memory");
  std::copy_n(static_cast<const char*>(LockResource(LoadResource(nullptr, found))), size,
              static_cast<char*>(GlobalLock(memory)));
  GlobalUnlock(memory);
  IStream* stream = nullptr;
  if (FAILED(CreateStreamOnHGlobal(memory, TRUE, &stream))) fail_to_draw("no stream");
  std::unique_ptr<Gdiplus::Bitmap> picture(Gdiplus::Bitmap::FromStream(stream));
  stream->Release();
  if (!picture || picture->GetLastStatus() != Gdiplus::Ok) fail_to_draw("its PNG cannot be read");
  return picture;
}

// A bitmap whose pixels GDI+ and GDI share, in a device context.
class Canvas {
 public:
  explicit Canvas(Size size) : device_(CreateCompatibleDC(nullptr)) {
    BITMAPINFO info{};
    info.bmiHeader.biSize = sizeof info.bmiHeader;
    info.bmiHeader.biWidth = size.width_px;
    info.bmiHeader.biHeight = -size.height_px;  // Top row first.
    info.bmiHeader.biPlanes = 1;
    info.bmiHeader.biBitCount = 32;
    void* pixels = nullptr;
    bitmap_ = CreateDIBSection(device_, &info, DIB_RGB_COLORS, &pixels, nullptr, 0);
    if (bitmap_ == nullptr) fail_to_draw("no bitmap");
    before_ = SelectObject(device_, bitmap_);
    pixels_ = static_cast<BYTE*>(pixels);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas() {
    SelectObject(device_, before_);
    DeleteObject(bitmap_);
    DeleteDC(device_);
  }

  HDC device() const { return device_; }
  BYTE* pixels() const { return pixels_; }

 private:
  HDC device_;
  HBITMAP bitmap_ = nullptr;
  HGDIOBJ before_ = nullptr;
  BYTE* pixels_ = nullptr;
};

void draw_picture(const Canvas& canvas, const SpriteLook& look, Size size) {
  const auto picture = load(picture_of(look.pose, size.width_px));
  if (look.faces_left) picture->RotateFlip(Gdiplus::RotateNoneFlipX);
  Gdiplus::Bitmap target(size.width_px, size.height_px, 4 * size.width_px, PixelFormat32bppPARGB,
                         canvas.pixels());
  Gdiplus::Graphics graphics(&target);
  graphics.SetCompositingMode(Gdiplus::CompositingModeSourceCopy);
  const bool is_exact = static_cast<INT>(picture->GetWidth()) == size.width_px;  // Then pixels are copied.
  graphics.SetInterpolationMode(is_exact ? Gdiplus::InterpolationModeNearestNeighbor
                                         : Gdiplus::InterpolationModeHighQualityBicubic);
  graphics.SetPixelOffsetMode(Gdiplus::PixelOffsetModeHighQuality);
  const auto drawn = graphics.DrawImage(picture.get(), Gdiplus::Rect(0, 0, size.width_px, size.height_px), 0,
                                        0, static_cast<INT>(picture->GetWidth()),
                                        static_cast<INT>(picture->GetHeight()), Gdiplus::UnitPixel);
  if (drawn != Gdiplus::Ok) fail_to_draw("GDI+ status " + std::to_string(drawn));
}

HWND create_window(HINSTANCE instance, WNDPROC procedure, void* window) {
  WNDCLASSEXW window_class{};
  window_class.cbSize = sizeof window_class;
  window_class.lpfnWndProc = procedure;
  window_class.hInstance = instance;
  window_class.hIcon = LoadIconW(instance, MAKEINTRESOURCEW(HYRAX_ICON));
  window_class.hCursor = LoadCursorW(nullptr, IDC_HAND);
  window_class.lpszClassName = L"hyrax";
  RegisterClassExW(&window_class);
  const HWND handle =
      CreateWindowExW(WS_EX_LAYERED | WS_EX_TOPMOST | WS_EX_TOOLWINDOW | WS_EX_NOACTIVATE, L"hyrax", L"Hyrax",
                      WS_POPUP, 0, 0, 1, 1, nullptr, nullptr, instance, window);
  if (handle == nullptr)
    throw Failure(ExitCode::cannot_access, "hyrax: the window cannot be created (error " +
                                               std::to_string(GetLastError()) +
                                               "); it needs the screen of a user who is logged in");
  return handle;
}

ULONG_PTR start_gdiplus() {
  ULONG_PTR token = 0;
  const Gdiplus::GdiplusStartupInput input;
  if (Gdiplus::GdiplusStartup(&token, &input, nullptr) != Gdiplus::Ok)
    throw Failure(ExitCode::cannot_access, "hyrax: GDI+, which draws the hyrax, cannot be started");
  return token;
}

}  // namespace

Window::Window(HINSTANCE instance, Handler handler)
    : gdiplus_(start_gdiplus()), handler_(std::move(handler)) {
  handle_ = create_window(instance, &Window::window_procedure, this);  // It sends messages already.
}

Window::~Window() {
  if (handle_ != nullptr) DestroyWindow(handle_);
  Gdiplus::GdiplusShutdown(gdiplus_);
}

LRESULT CALLBACK Window::window_procedure(HWND handle, UINT message, WPARAM wide, LPARAM low) {
  if (message == WM_NCCREATE)
    SetWindowLongPtrW(handle, GWLP_USERDATA,
                      reinterpret_cast<LONG_PTR>(reinterpret_cast<CREATESTRUCTW*>(low)->lpCreateParams));
  auto* const window = reinterpret_cast<Window*>(GetWindowLongPtrW(handle, GWLP_USERDATA));
  // Messages during creation and after closing are not for the handler.
  if (window == nullptr || window->handle_ == nullptr) return DefWindowProcW(handle, message, wide, low);
  LRESULT result = 0;
  try {
    result = window->handler_(message, wide, low);
  } catch (...) {
    window->failure_ = std::current_exception();
    PostMessageW(handle, WM_NULL, 0, 0);
  }
  if (message == WM_DESTROY) window->handle_ = nullptr;
  return result;
}

void Window::show(const SpriteLook& look, ScreenPoint at) {
  if (look != shown_) draw(look);
  if (at == shown_at_) return;
  shown_at_ = at;
  SetWindowPos(handle_, nullptr, at.x_px, at.y_px, 0, 0,
               SWP_NOSIZE | SWP_NOZORDER | SWP_NOACTIVATE | SWP_NOOWNERZORDER);
}

void Window::draw(const SpriteLook& look) {
  const Size size{std::clamp(look.size.width_px, 1, kSideMax_px),
                  std::clamp(look.size.height_px, 1, kSideMax_px)};
  const Canvas canvas(size);
  draw_picture(canvas, look, size);
  SIZE extent{size.width_px, size.height_px};
  POINT origin{0, 0};
  BLENDFUNCTION blend{AC_SRC_OVER, 0, 255, AC_SRC_ALPHA};
  if (UpdateLayeredWindow(handle_, nullptr, nullptr, &extent, canvas.device(), &origin, 0, &blend,
                          ULW_ALPHA) != 0)
    shown_ = look;
}

ScreenRect Window::rect() const {
  RECT rect{};
  GetWindowRect(handle_, &rect);
  return {static_cast<std::int32_t>(rect.left), static_cast<std::int32_t>(rect.top),
          static_cast<std::int32_t>(rect.right), static_cast<std::int32_t>(rect.bottom)};
}

void Window::rethrow_failure() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

Window::Modal::Modal(Window& window) : window_(window) {
  if (window_.modals_++ == 0) SetTimer(window_.handle_, kModalTimer, USER_TIMER_MINIMUM, nullptr);
}

Window::Modal::~Modal() {
  if (--window_.modals_ == 0) KillTimer(window_.handle_, kModalTimer);
}

}  // namespace hyrax

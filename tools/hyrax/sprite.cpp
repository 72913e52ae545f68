#include "tools/hyrax/sprite.h"

#include <objidl.h>

#include <algorithm>
#include <array>
#include <string>
using std::max;
using std::min;
#include <gdiplus.h>

#include "tools/files/failure.h"
#include "tools/hyrax/resource_ids.h"

namespace hyrax {
namespace {

constexpr int kSideMax_px = 2048;  // Of what is drawn, however large a scenario's sprite is.

[[noreturn]] void fail_to_draw(const std::string& what) {
  throw Failure(ExitCode::program_fault, "hyrax: the sprite cannot be drawn: " + what);
}

int resource_base(Pose pose) {
  switch (pose) {
    case Pose::fly:
      return HYRAX_FLY;
    case Pose::held:
      return HYRAX_HELD;
    case Pose::stand:
      return HYRAX_STAND;
    case Pose::sleep:
      return HYRAX_SLEEP;
  }
  return HYRAX_FLY;
}

// The smallest that need not be made larger.
int resource_of(Pose pose, int width_px) {
  for (const int percentage : {100, 125, 150, 175})
    if (128 * percentage / 100 >= width_px) return resource_base(pose) + percentage;
  return resource_base(pose) + 200;
}

std::unique_ptr<::Gdiplus::Bitmap> load(int resource) {
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
  std::unique_ptr<::Gdiplus::Bitmap> picture(::Gdiplus::Bitmap::FromStream(stream));
  stream->Release();
  if (!picture || picture->GetLastStatus() != ::Gdiplus::Ok) fail_to_draw("its PNG cannot be read");
  return picture;
}

// A bitmap whose pixels GDI+ and GDI both know, and a device context that holds it.
class Canvas {
 public:
  explicit Canvas(Size size) : device_(CreateCompatibleDC(nullptr)) {
    BITMAPINFO info{};
    info.bmiHeader.biSize = sizeof info.bmiHeader;
    info.bmiHeader.biWidth = size.width_px;
    info.bmiHeader.biHeight = -size.height_px;  // From the top down.
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

void draw(const Canvas& canvas, const Look& look, Size size) {
  const auto picture = load(resource_of(look.pose, size.width_px));
  if (look.faces_left) picture->RotateFlip(::Gdiplus::RotateNoneFlipX);
  ::Gdiplus::Bitmap target(size.width_px, size.height_px, 4 * size.width_px, PixelFormat32bppPARGB,
                           canvas.pixels());
  ::Gdiplus::Graphics graphics(&target);
  graphics.SetCompositingMode(::Gdiplus::CompositingModeSourceCopy);
  const bool is_exact = static_cast<INT>(picture->GetWidth()) == size.width_px;  // Then no pixel is mixed.
  graphics.SetInterpolationMode(is_exact ? ::Gdiplus::InterpolationModeNearestNeighbor
                                         : ::Gdiplus::InterpolationModeHighQualityBicubic);
  graphics.SetPixelOffsetMode(::Gdiplus::PixelOffsetModeHighQuality);
  const auto drawn = graphics.DrawImage(picture.get(), ::Gdiplus::Rect(0, 0, size.width_px, size.height_px),
                                        0, 0, static_cast<INT>(picture->GetWidth()),
                                        static_cast<INT>(picture->GetHeight()), ::Gdiplus::UnitPixel);
  if (drawn != ::Gdiplus::Ok) fail_to_draw("GDI+ status " + std::to_string(drawn));
}

}  // namespace

Gdiplus::Gdiplus() {
  const ::Gdiplus::GdiplusStartupInput input;
  if (::Gdiplus::GdiplusStartup(&token_, &input, nullptr) != ::Gdiplus::Ok)
    throw Failure(ExitCode::cannot_access, "hyrax: GDI+ cannot be started, which draws the hyrax");
}

Gdiplus::~Gdiplus() { ::Gdiplus::GdiplusShutdown(token_); }

void Sprite::show(HWND window, const Look& look) {
  if (look == shown_) return;
  const Size size{std::clamp(look.size.width_px, 1, kSideMax_px),
                  std::clamp(look.size.height_px, 1, kSideMax_px)};
  const Canvas canvas(size);
  draw(canvas, look, size);
  SIZE extent{size.width_px, size.height_px};
  POINT origin{0, 0};
  BLENDFUNCTION blend{AC_SRC_OVER, 0, 255, AC_SRC_ALPHA};
  if (UpdateLayeredWindow(window, nullptr, nullptr, &extent, canvas.device(), &origin, 0, &blend,
                          ULW_ALPHA) != 0)
    shown_ = look;
}

}  // namespace hyrax

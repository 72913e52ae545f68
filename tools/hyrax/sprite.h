// The hyrax's picture on its window.
#pragma once

#include <memory>

#include <windows.h>

#include "tools/hyrax/pet.h"

namespace hyrax {

/// GDI+ from its construction on.
class Gdiplus {
 public:
  /// ERRORS: Failure(cannot_access).
  Gdiplus();
  Gdiplus(const Gdiplus&) = delete;
  Gdiplus& operator=(const Gdiplus&) = delete;
  ~Gdiplus();

 private:
  ULONG_PTR token_ = 0;
};

/// What is to be seen.
struct Look {
  Pose pose = Pose::fly;
  bool faces_left = false;
  Size size;
  bool operator==(const Look&) const = default;
};

/// Draws a layered window with its alpha, pixel by pixel, from the PNG resources: the one of just this
/// size, or a larger one made smaller.
class Sprite {
 public:
  /// Draws if it is not what the window shows already. ERRORS: Failure(program_fault).
  void show(HWND window, const Look& look);

 private:
  Look shown_;
};

}  // namespace hyrax

// Rounding and subnormals as the core needs them, whatever a loaded library left behind.
#pragma once

#include <xmmintrin.h>

namespace hyrax {

/// Round to nearest, no flushing, no traps. Libraries that come into a desktop program (printer drivers,
/// input methods, overlays) run on its thread and may leave other modes, so this stands before each frame.
inline void pin_arithmetic() {
  constexpr unsigned kModes = 0x1F80;
  constexpr unsigned kStickyFlags = 0x3F;
  if ((_mm_getcsr() & ~kStickyFlags) != kModes) _mm_setcsr(kModes);
}

}  // namespace hyrax

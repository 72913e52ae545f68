// Sets rounding and subnormals as the core needs them, whatever a loaded library did.
#pragma once

#include <xmmintrin.h>

namespace hyrax {

/// Round to nearest, no flushing, no traps. Libraries loaded into a desktop program (printer drivers, input
/// methods, overlays) run in its thread and may change the modes, so this is called before each frame.
inline void pin_arithmetic() {
  constexpr unsigned kModes = 0x1F80;
  constexpr unsigned kStickyFlags = 0x3F;
  if ((_mm_getcsr() & ~kStickyFlags) != kModes) _mm_setcsr(kModes);
}

}  // namespace hyrax

// A core whose calls are looked at for what they do to the processor.
#pragma once

#include "sim/core/core.h"

namespace hyrax {

/// The core, with every call followed by a look at the control bits of floating-point arithmetic: rounding
/// and flush-to-zero, not the sticky flags. Where they changed they are restored. ERRORS: of its stepper's
/// functions Failure(not_strict_ieee), with the row that the first such step makes, found by a second play.
[[nodiscard]] Core controlled(Core core);

}  // namespace hyrax

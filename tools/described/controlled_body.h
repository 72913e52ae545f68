// A core that describes itself whose calls are looked at for what they do to the processor.
#pragma once

#include <atomic>

#include "sim/described/described_core.h"

namespace hyrax {

/// The core, of which a step, an action or a setter that changes rounding or flush-to-zero throws, which ends
/// the run at its row, and sets `has_changed`. The bits are then as they were. @param has_changed must
/// outlive the core.
[[nodiscard]] DescribedCore controlled(DescribedCore core, std::atomic<bool>& has_changed);

}  // namespace hyrax

// Tells one core from another by the bits that it gives.
#pragma once

#include "sim/core/core.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// The digest of some hundred steps, from states at, beside and far from the bounds, at all speeds, with zero
/// and long frames and inputs, and of flings that bounce to rest. The same core gives the same digest
/// on every processor; another one gives another, unless it differs where none of these steps leads.
[[nodiscard]] Digest fingerprint_of(const Core& core);

}  // namespace hyrax

// `bless` for cores of the paper's interface.
#pragma once

#include <memory>

#include "sim/core/core.h"
#include "tools/app/library/blessing.h"

namespace hyrax {

/// Refers to the core.
[[nodiscard]] std::unique_ptr<Blesser> blesser_of(const Core& core);

}  // namespace hyrax

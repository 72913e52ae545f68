// What a changed core does beyond its library: against the exact fling, as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include "sim/search/beyond_library.h"
#include "tools/files/json.h"

namespace hyrax {

/// The end of the exact fling by these constants, without which none is known.
[[nodiscard]] ExactEnd exact_end(const std::optional<Constants>& constants);

/// One paragraph: complete lines, indented by two.
[[nodiscard]] std::string beyond_text(const BeyondLibrary& beyond);
/// {"flings", "other_bits", ...}
[[nodiscard]] Json beyond_json(const BeyondLibrary& beyond);

}  // namespace hyrax

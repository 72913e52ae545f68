// Statements of a step as the listing writes them.
#pragma once

#include <string>

#include "sim/motion/statement.h"

namespace hyrax {

/// As "vx *= AIR_DRAG"; constants by their names, whatever their values. A wall is its condition: "x < 0".
[[nodiscard]] std::string statement_text(const Statement& statement);

}  // namespace hyrax

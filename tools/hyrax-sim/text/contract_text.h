// Under which floating-point contracts two files were made, and what that says of their difference.
#pragma once

#include <string>

#include "sim/compare/comparison.h"
#include "tools/store/provenance.h"

namespace hyrax {

/// Which of program, compiler, flags, target, instruction set and self-test differ, and what that
/// usually means for a difference of that class. Lines indented by two, each with its end.
[[nodiscard]] std::string contract_text(const Provenance& a, const Provenance& b, DifferenceClass difference);

}  // namespace hyrax

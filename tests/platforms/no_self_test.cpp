// A self-test that finds nothing; linked before the core's library in a control.
#include "sim/physics/strict_arithmetic.h"

namespace hyrax {

std::optional<std::string_view> arithmetic_fault() { return std::nullopt; }

}  // namespace hyrax

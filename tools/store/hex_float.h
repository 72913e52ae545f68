// Doubles to the bit, for people.
#pragma once

#include <string>

namespace hyrax {

/// As `printf("%a")` writes it in the C locale, "-0x1.b0187ccff2edbp+4", whatever the locale is.
[[nodiscard]] std::string hex_float(double value);

}  // namespace hyrax

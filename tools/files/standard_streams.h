// Standard output and standard error: everything that the program prints goes through here, for paths and
// messages of others may hold what a terminal obeys.
#pragma once

#include <string_view>

namespace hyrax {

/// Prints text on standard output, control characters escaped. A failure ends nothing: what was begun is
/// finished, and main asks at the end.
void print_text(std::string_view text);

/// Writes what is held back; whether all that was printed is written.
[[nodiscard]] bool is_all_printed();

/// Prints sentences on standard error, a line end after them. A closed standard error changes no verdict.
void print_error(std::string_view sentences);

}  // namespace hyrax

// Text that others wrote (paths, JSON keys, messages of the system) on its way to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// The text in one line that does nothing to a terminal: control characters (C0, DEL, C1) as in JSON,
/// "\u001b", bytes that are no UTF-8 as "\x9b".
[[nodiscard]] std::string printable(std::string_view text);

/// The same, with its line ends and tabs kept. JSON text keeps its meaning.
[[nodiscard]] std::string printable_lines(std::string_view text);

}  // namespace hyrax

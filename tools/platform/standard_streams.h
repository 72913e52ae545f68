// Standard input, output and error, and the terminal behind them.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>

namespace hyrax {

/// At the start of a program: a file that it opens is none of these streams, whichever of them are closed;
/// what it reads and writes is bytes, and UTF-8 on a terminal.
void prepare_standard_streams();

/// Standard output once more, for bytes, to be closed by itself. nullptr, with errno: it cannot be opened.
[[nodiscard]] std::FILE* open_standard_output();

[[nodiscard]] bool is_terminal(std::FILE* stream);

/// The width of standard output; nothing: it is no terminal, or one that does not know it.
[[nodiscard]] std::optional<std::size_t> terminal_columns();

}  // namespace hyrax

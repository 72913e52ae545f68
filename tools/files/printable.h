// Text of any origin (paths, JSON keys, messages of the system) made safe for a terminal, and printed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax {

struct Utf8Character {
  std::size_t bytes = 1;   ///< 1 to 4; 1 if no character begins there.
  std::int32_t code = -1;  ///< Its code point; -1 if the byte is not UTF-8.
};

/// The character that begins at `at`: shortest form, no surrogate, at most U+10FFFF (RFC 3629).
/// REQUIRES: at < text.size().
[[nodiscard]] Utf8Character utf8_character(std::string_view text, std::size_t at);

/// Whether the character does something to a terminal or reorders the text beside it: C0, DEL, C1, line
/// separators, bidirectional controls.
[[nodiscard]] bool is_control(std::int32_t code);

/// The text in one line that does nothing to a terminal: control characters as in JSON, "\u001b", bytes that
/// are not UTF-8 as "\x9b".
[[nodiscard]] std::string printable(std::string_view text);

/// The same, with line ends and tabs kept. JSON text keeps its meaning.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// The text, or its first 60 bytes, cut where a character of UTF-8 begins, and "...": for a message.
[[nodiscard]] std::string shortened(std::string_view text);

/// "812 bytes", "3.4 MiB": a size to one decimal, in the largest binary unit that it reaches.
[[nodiscard]] std::string size_text(std::uint64_t bytes);

/// Prints text on standard output, control characters escaped. A failure is not reported: the command
/// completes, and main asks is_all_printed at the end.
void print_text(std::string_view text);

/// Flushes standard output. Whether all that was printed is written.
[[nodiscard]] bool is_all_printed();

/// Names the program by `own` in messages that name it `documented`, at their start or in a suggested
/// command: a program with a core of one's own. At start.
void name_program(const std::string& documented, const std::string& own);

/// The text with that name.
[[nodiscard]] std::string with_own_name(std::string_view sentences);

/// Prints text and a line end on standard error, control characters escaped. A failure is ignored.
void print_error(std::string_view sentences);

}  // namespace hyrax

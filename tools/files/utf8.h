// Text of any origin, as paths are: which of its bytes are UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hyrax {

/// One character of a text.
struct Utf8Character {
  std::size_t bytes = 1;   ///< 1 to 4; 1 where no character begins.
  std::int32_t code = -1;  ///< Its code point; -1 where no character begins: the byte is no UTF-8.
};

/// The character that begins at `at`: shortest form, no surrogate, at most U+10FFFF (RFC 3629).
/// REQUIRES: at < text.size().
[[nodiscard]] Utf8Character utf8_character(std::string_view text, std::size_t at);

}  // namespace hyrax

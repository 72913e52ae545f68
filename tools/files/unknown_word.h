// The message for a word that is not allowed: a key, a value, an option, a command.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// "A, B, C"; of very many the first, "and 460 more"; "none" without words.
[[nodiscard]] std::string listed(std::span<const std::string_view> words);

/// "unknown KIND (found WORD); allowed: A, B (did you mean B?)". The suggestion is the first of the words
/// with the fewest typing errors, if they are few for its length; a truncated word counts as one error. None
/// if only one word is allowed.
[[nodiscard]] std::string unknown_word(std::string_view kind, std::string_view found,
                                       const std::vector<std::string_view>& allowed);

}  // namespace hyrax

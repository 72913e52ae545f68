// Sets values in a JSON text, of which every other byte stays as it was.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// The text with the value at the end of these keys, from the whole document on, set to `value`, a JSON text.
/// Members that are missing are added.
/// REQUIRES: a valid JSON text, in which each of the keys, where it is there, leads to an object or is the
/// last.
[[nodiscard]] std::string with_value(std::string_view text, const std::vector<std::string_view>& keys,
                                     std::string_view value);

/// The same for a value that is there: of an array, its elements are set; another value to the first of
/// `values`. REQUIRES: as many elements as `values`.
[[nodiscard]] std::string with_elements(std::string_view text, const std::vector<std::string_view>& keys,
                                        const std::vector<std::string>& values);

}  // namespace hyrax

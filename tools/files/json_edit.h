// Sets values in a JSON text, of which every other byte stays as it was.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// The texts of the elements of the array at the end of these keys, from the whole document on; of another
/// value its own. REQUIRES: a valid JSON text that has the keys.
[[nodiscard]] std::vector<std::string> element_texts(std::string_view text,
                                                     const std::vector<std::string_view>& keys);

/// The text with the first of these elements set to `values`, JSON texts. REQUIRES: as element_texts'; not
/// more values than elements.
[[nodiscard]] std::string with_elements(std::string_view text, const std::vector<std::string_view>& keys,
                                        const std::vector<std::string>& values);

}  // namespace hyrax

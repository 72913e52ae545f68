// Reads the description of a core as files have it.
#pragma once

#include <string>

#include "sim/described/description.h"

namespace hyrax {

/// The description in a text of description_json, without ranges and undeclared parts, which it does not
/// have.
/// @param source names the text in messages.
/// ERRORS: Failure(bad_input).
[[nodiscard]] Description parse_description(const std::string& text, const std::string& core,
                                            const std::string& source);

}  // namespace hyrax

// JSON Pointers (RFC 6901): places in a document.
#pragma once

#include <string>
#include <string_view>

#include "tools/files/json.h"

namespace hyrax {

/// The pointer to a member or element of the place that `pointer` names.
[[nodiscard]] std::string pointer_to(const std::string& pointer, std::string_view token);

/// Sets the value at a pointer. Missing objects on the way are created; "-" appends to an array.
/// @param source begins the message, if it is not empty.
/// ERRORS: Failure(bad_input) "SOURCE: POINTER: ..." if it is not a pointer, is deeper than a document may
/// nest, or leads through something that has no members.
void set_at(Json& document, std::string_view pointer, Json value, const std::string& source = "");

}  // namespace hyrax

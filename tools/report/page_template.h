// The report page without its data.
#pragma once

#include <string_view>

namespace hyrax {

/// The page with an empty place for its data; empty if this program was built without it (the CMake option
/// HYRAX_PAGE).
[[nodiscard]] std::string_view page_template();

}  // namespace hyrax

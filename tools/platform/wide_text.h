// On Windows: text and paths for the system's wide functions.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

[[nodiscard]] std::wstring to_wide(std::string_view utf8);
[[nodiscard]] std::string to_utf8(std::wstring_view wide);
/// For the system's wide functions, which take a path of any length if it is absolute and marked so.
[[nodiscard]] std::wstring system_path(const std::string& path);

}  // namespace hyrax

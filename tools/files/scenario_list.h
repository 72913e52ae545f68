// The scenario files that arguments name.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// A file is itself, a folder every *.json in it, recursively, through links, in name order. A link that
/// leads nowhere is in the list if it is named *.json, or has no suffix: reading it fails. ERRORS:
/// Failure(bad_input) where a folder holds none, or more than a million files; Failure(cannot_access) where a
/// folder cannot be read, or a *.json in it is a pipe or a device.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments);

}  // namespace hyrax

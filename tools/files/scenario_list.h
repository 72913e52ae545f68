// Finds the scenario files that arguments name.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// Files as they are; of a folder every *.json in it, recursively, through links, in name order. A broken
/// link is listed if it is named *.json or has no suffix: reading it fails. ERRORS: Failure(bad_input) if a
/// folder has no scenario, or more than a million files; Failure(cannot_access) if a folder cannot be read,
/// or a *.json in it is a pipe or a device.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments);

}  // namespace hyrax

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

/// With no arguments: `scenarios` of the current folder, and its `golden` if no golden folder was given.
/// ERRORS: Failure(bad_input) if there are no arguments and no folder `scenarios`.
void set_default_folders(std::vector<std::string>& arguments, std::string& golden_folder);

}  // namespace hyrax

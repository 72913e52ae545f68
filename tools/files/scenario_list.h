// Finds the scenario files that arguments name.
#pragma once

#include <string>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

/// Files as they are; of a folder every *.json in it, recursively, through links, in name order, except JSON
/// Schemas named *.schema.json. What could hide a scenario is listed as well, and reading it fails: a folder
/// that cannot be read, a link that leads nowhere and is named *.json or has no suffix, a pipe or device
/// named *.json, and *.JSON.
/// ERRORS: Failure(bad_input) if a folder has no scenario, or more than a million files.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments);

/// As above, but each scenario once, and its failures are added to `unlisted`, one a folder that it refuses,
/// and the others are listed.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments,
                                                      std::vector<Failure>& unlisted);

/// With no arguments: `scenarios` of the current folder.
/// ERRORS: Failure(bad_input) if there are no arguments and no folder `scenarios`.
void set_default_folder(std::vector<std::string>& arguments);

}  // namespace hyrax

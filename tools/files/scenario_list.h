// The scenario files that arguments stand for.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// A file stands for itself, a folder for every *.json in it, recursively, in name order.
/// ERRORS: Failure(bad_input) where a folder holds none; Failure(cannot_access) where it cannot be read.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments);

}  // namespace hyrax

// New values of `expect` in the text of a scenario; nothing else in it changes.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/expectations.h"

namespace hyrax {

/// With new values for ranges that do not hold: they keep their width; counts become the new ones.
/// REQUIRES: is_updatable_range of each.
[[nodiscard]] std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges);

/// REQUIRES: `expect` has a state hash.
[[nodiscard]] std::string with_updated_hash(const std::string& text, const std::string& state_hash);

}  // namespace hyrax

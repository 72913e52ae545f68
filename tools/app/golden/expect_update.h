// New values for what a scenario expects, where its run has others.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/expectations.h"

namespace hyrax {

/// Whether a run can give an expectation that does not hold a new range: a count, a range with two ends. No
/// error bound or one-sided limit, and nothing that the run does not have.
[[nodiscard]] bool is_updatable_range(const Expectation& broken);

/// The same, or the state hash; no boolean.
[[nodiscard]] bool is_updatable(const Expectation& broken);

/// The scenario's text with new values for ranges that do not hold: they keep their width, with the new value
/// in the middle; counts become the new ones. REQUIRES: updatable ones, that the run of this scenario broke.
[[nodiscard]] std::string with_updated_ranges(std::string text, const std::vector<Expectation>& ranges);

}  // namespace hyrax

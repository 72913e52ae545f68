// New values for what a scenario expects, where its run has others.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/expectations.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Whether a run can give an expectation that does not hold a new value: a count, a range with two ends, the
/// state hash. No boolean, error bound or one-sided limit, and nothing that the run does not have.
[[nodiscard]] bool is_updatable(const Expectation& broken);

/// The scenario's text with new values for those of `broken` that are updatable: ranges keep their width,
/// with the new value in the middle; counts become the new ones. The state hash is left as it is. REQUIRES:
/// the text of this scenario, whose run broke them.
[[nodiscard]] std::string with_updated_ranges(std::string text, const Scenario& scenario,
                                              const std::vector<Expectation>& broken);

}  // namespace hyrax

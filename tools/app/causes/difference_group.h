// Scenarios whose runs are not their golden files', grouped by the causes of cores of the paper's interface.
#pragma once

#include <string>
#include <vector>

#include "tools/app/causes/core_check.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/library/difference_group.h"

namespace hyrax {

/// The verdict on a scenario of such a group.
[[nodiscard]] inline const PairVerdict& pair_of(const ScenarioVerdict& scenario) {
  return static_cast<const PairVerdict&>(scenario);
}

/// The non_finite_text of a run that differs; empty where it stays finite.
[[nodiscard]] std::string non_finite_text(const PairVerdict& scenario);

/// Runs that become non-finite first; then known causes by their size, then unknown ones. The cores take the
/// runs that differ because of them.
/// @param scenarios whose runs are not their golden files'; they outlive the groups.
[[nodiscard]] std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                                          CoreChecks& cores);

}  // namespace hyrax

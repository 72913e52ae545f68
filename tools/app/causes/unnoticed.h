// Differences of two cores that no scenario of a library shows, each with a scenario that does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/trace/step_difference.h"

namespace hyrax {

/// A difference of two steps that no scenario of the library shows.
struct UnnoticedDifference {
  std::string text;
  std::optional<Scenario> scenario;  ///< Shows it, where the search found a step.
  std::string consequence;           ///< As "after 5 s 12.3 px apart".
  std::int64_t steps_tried = 0;
};

/// The accepted core, this program's, and their steps. Refers to all.
struct CorePair {
  const StepPair& steps;
  const Core& accepted;
  const Core& program;
};

/// Marks in `noticed` (one a difference) those that a row of the scenario shows, played by the accepted core.
void notice(const CorePair& cores, const Scenario& scenario, std::vector<bool>& noticed);

/// Searches for a scenario for each difference that is not noticed: the same on every machine.
[[nodiscard]] std::vector<UnnoticedDifference> search_unnoticed(const CorePair& cores,
                                                                const std::vector<bool>& noticed);

}  // namespace hyrax

// The search for a step that shows a difference of two traced steps.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/trace/step_difference.h"
#include "sim/trace/step_program.h"

namespace hyrax {

/// A difference, as the search sees it.
struct SearchTarget {
  const StepProgram* owner = nullptr;  ///< Of the step that has it.
  const StepProgram* other = nullptr;
  std::vector<bool> is_on_path = {};  ///< By path of the owner's update: whether it evaluates the difference.
  std::int32_t comparison = -1;       ///< In the owner; -1: the difference is no comparison.
};

/// As StepPair::search.
[[nodiscard]] DifferenceSearch search_difference(const SearchTarget& target, std::uint64_t seed,
                                                 std::int64_t steps_max);

}  // namespace hyrax

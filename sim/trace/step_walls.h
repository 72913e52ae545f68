// Which walls a path of a traced step meets, by its own comparisons.
#pragma once

#include <vector>

#include "sim/motion/state.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// The expressions of a velocity; kNoIndex: it cannot be told.
struct VelocityIndices {
  StepIndex vx = kNoIndex;
  StepIndex vy = kNoIndex;
};

/// A comparison of a position with a wall's bound that decided "beyond".
struct PathContact {
  Wall wall = Wall::left;
  StepIndex position = kNoIndex;  ///< Expressions.
  StepIndex bound = kNoIndex;
  VelocityIndices before = {};  ///< At the comparison.
  VelocityIndices after = {};   ///< At the next wall of the path, or at its end.
};

/// For each path of update its contacts, in the order in which it has them: each wall at most once. A bound
/// is the constant 0, or an expression of the sizes. A position is x or y, and what is added to it.
[[nodiscard]] std::vector<std::vector<PathContact>> find_path_contacts(const TracedStep& step);

}  // namespace hyrax

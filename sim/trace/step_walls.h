// Which walls a path of a traced step meets, by its own comparisons.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/motion/state.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// A comparison of a position with a wall's bound that decided "beyond". All are indices of expressions.
struct PathContact {
  Wall wall = Wall::left;
  std::int32_t position = -1;
  std::int32_t bound = -1;
  std::int32_t vx_before = -1;  ///< At the comparison; -1: cannot be told.
  std::int32_t vy_before = -1;
  std::int32_t vx_after = -1;  ///< At the next wall of the path, or at its end.
  std::int32_t vy_after = -1;
};

/// For each path of update its contacts, in the order in which it has them: each wall at most once. A bound
/// is the constant 0, or an expression of the sizes. A position is x or y, and what is added to it.
[[nodiscard]] std::vector<std::vector<PathContact>> find_path_contacts(const TracedStep& step);

}  // namespace hyrax

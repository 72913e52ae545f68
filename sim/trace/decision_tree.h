// The paths of a function: as a tree of decisions, and what each evaluates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// Asks a comparison, or ends a path.
struct DecisionNode {
  std::int32_t comparison = -1;  ///< Index in TracedStep::comparisons; -1 at the end of a path.
  std::int32_t path = -1;        ///< There: its index.
  std::int32_t if_false = -1;    ///< Nodes.
  std::int32_t if_true = -1;
};

/// Node 0 is the root, and a node comes before those it leads to. Of the comparisons that all paths still
/// possible have, the lowest is asked first. Nothing if some outcomes lead to no path, or to two.
/// REQUIRES: outcomes of a path by their comparison, each comparison once.
[[nodiscard]] std::optional<std::vector<DecisionNode>> make_decision_tree(const std::vector<StepPath>& paths);

/// Marks, with each expression that is marked, those that it is made of.
void add_operands(const TracedStep& step, std::vector<bool>& expressions);

/// By expression: whether the path evaluates it.
[[nodiscard]] std::vector<bool> evaluated_by(const TracedStep& step, const StepPath& path);

}  // namespace hyrax

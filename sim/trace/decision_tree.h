// The paths of a function: as a tree of decisions, and what each evaluates.
#pragma once

#include <optional>
#include <vector>

#include "sim/trace/traced_step.h"

namespace hyrax {

/// Asks a comparison, or ends a path.
struct DecisionNode {
  StepIndex comparison = kNoIndex;  ///< In TracedStep::comparisons; kNoIndex at the end of a path.
  StepIndex path = kNoIndex;        ///< There: its index.
  StepIndex if_false = kNoIndex;    ///< The node that follows; the one behind that if the comparison holds.
};

/// Node 0 is the root, and a node comes before those it leads to. Of the comparisons that all paths still
/// possible have, the lowest is asked first. Nothing if some outcomes lead to no path, or to two.
/// REQUIRES: outcomes of a path by their comparison, each comparison once.
[[nodiscard]] std::optional<std::vector<DecisionNode>> make_decision_tree(const std::vector<StepPath>& paths);

/// Marks the expressions that the path compares and those that it ends with.
void add_ends(const TracedStep& step, const StepPath& path, std::vector<bool>& expressions);

/// Marks, with each expression that is marked, those that it is made of.
void add_operands(const TracedStep& step, std::vector<bool>& expressions);

/// By expression: whether the path evaluates it.
[[nodiscard]] std::vector<bool> evaluated_by(const TracedStep& step, const StepPath& path);

}  // namespace hyrax

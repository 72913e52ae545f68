#include "sim/trace/decision_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hyrax {
namespace {

// A node whose paths are known, not yet what it asks.
struct OpenNode {
  std::size_t node = 0;
  std::vector<std::int32_t> paths;
  std::vector<std::int32_t> asked;  // Comparisons on the way to it, sorted.
};

const StepOutcome* outcome_of(const StepPath& path, std::int32_t comparison) {
  const auto place = std::ranges::lower_bound(path.outcomes, comparison, {}, &StepOutcome::comparison);
  return place != path.outcomes.end() && place->comparison == comparison ? &*place : nullptr;
}

// Of those that all paths have and that were not asked; -1: none.
std::int32_t lowest_common(const std::vector<StepPath>& paths, const OpenNode& open) {
  const auto path = [&](std::int32_t index) -> const StepPath& {
    return paths[static_cast<std::size_t>(index)];
  };
  for (const StepOutcome& outcome : path(open.paths.front()).outcomes) {
    if (std::binary_search(open.asked.begin(), open.asked.end(), outcome.comparison)) continue;
    if (std::all_of(open.paths.begin(), open.paths.end(), [&](std::int32_t index) {
          return outcome_of(path(index), outcome.comparison) != nullptr;
        }))
      return outcome.comparison;
  }
  return -1;
}

}  // namespace

std::optional<std::vector<DecisionNode>> make_decision_tree(const std::vector<StepPath>& paths) {
  if (paths.empty()) return std::nullopt;
  std::vector<DecisionNode> nodes(1);
  std::vector<OpenNode> open(1);
  open[0].paths.resize(paths.size());
  std::iota(open[0].paths.begin(), open[0].paths.end(), 0);
  while (!open.empty()) {
    OpenNode now = std::move(open.back());
    open.pop_back();
    const std::int32_t first = now.paths.front();
    if (now.paths.size() == 1 && paths[static_cast<std::size_t>(first)].outcomes.size() == now.asked.size()) {
      nodes[now.node].path = first;
      continue;
    }
    const std::int32_t comparison = lowest_common(paths, now);
    if (comparison < 0) return std::nullopt;
    OpenNode sides[2];
    for (const std::int32_t path : now.paths)
      sides[outcome_of(paths[static_cast<std::size_t>(path)], comparison)->holds ? 1 : 0].paths.push_back(
          path);
    if (sides[0].paths.empty() || sides[1].paths.empty()) return std::nullopt;
    now.asked.insert(std::upper_bound(now.asked.begin(), now.asked.end(), comparison), comparison);
    sides[0].node = nodes.size();
    sides[1].node = nodes.size() + 1;
    nodes[now.node].comparison = comparison;
    nodes[now.node].if_false = static_cast<std::int32_t>(sides[0].node);
    nodes[now.node].if_true = static_cast<std::int32_t>(sides[1].node);
    nodes.resize(nodes.size() + 2);
    for (OpenNode& side : sides) {
      side.asked = now.asked;
      open.push_back(std::move(side));
    }
  }
  return nodes;
}

void add_operands(const TracedStep& step, std::vector<bool>& expressions) {
  for (std::size_t index = expressions.size(); index-- > 0;)
    if (expressions[index])
      for (const std::int32_t operand : step.expressions[index].operands)
        if (operand >= 0) expressions[static_cast<std::size_t>(operand)] = true;
}

std::vector<bool> evaluated_by(const TracedStep& step, const StepPath& path) {
  std::vector<bool> evaluated(step.expressions.size());
  for (const std::int32_t member : path.members) evaluated[static_cast<std::size_t>(member)] = true;
  for (const StepOutcome& outcome : path.outcomes) {
    const StepComparison& comparison = step.comparisons[static_cast<std::size_t>(outcome.comparison)];
    evaluated[static_cast<std::size_t>(comparison.left)] =
        evaluated[static_cast<std::size_t>(comparison.right)] = true;
  }
  add_operands(step, evaluated);
  return evaluated;
}

}  // namespace hyrax

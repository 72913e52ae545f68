#include "sim/trace/decision_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hyrax {
namespace {

// A node whose paths are known, not yet what it asks.
struct OpenNode {
  std::size_t node = 0;
  std::vector<StepIndex> paths;
  std::vector<StepIndex> asked;  // Comparisons on the way to it, sorted.
};

const StepOutcome* outcome_of(const StepPath& path, StepIndex comparison) {
  const auto place = std::ranges::lower_bound(path.outcomes, comparison, {}, &StepOutcome::comparison);
  return place != path.outcomes.end() && place->comparison == comparison ? &*place : nullptr;
}

// Of those that all paths have and that were not asked; kNoIndex: none.
StepIndex lowest_common(const std::vector<StepPath>& paths, const OpenNode& open) {
  for (const auto& [comparison, holds] : paths[open.paths.front()].outcomes) {
    const auto has_it = [&, asked = comparison](StepIndex path) {
      return outcome_of(paths[path], asked) != nullptr;
    };
    if (!std::ranges::binary_search(open.asked, comparison) && std::ranges::all_of(open.paths, has_it))
      return comparison;
  }
  return kNoIndex;
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
    const StepIndex first = now.paths.front();
    if (now.paths.size() == 1 && paths[first].outcomes.size() == now.asked.size()) {
      nodes[now.node].path = first;
      continue;
    }
    const StepIndex comparison = lowest_common(paths, now);
    if (comparison == kNoIndex) return std::nullopt;
    now.asked.insert(std::ranges::upper_bound(now.asked, comparison), comparison);
    nodes[now.node].comparison = comparison;
    nodes[now.node].if_false = static_cast<StepIndex>(nodes.size());
    for (const bool holds : {false, true}) {
      OpenNode& side = open.emplace_back(OpenNode{nodes.size(), {}, now.asked});
      for (const StepIndex path : now.paths)
        if (outcome_of(paths[path], comparison)->holds == holds) side.paths.push_back(path);
      if (side.paths.empty()) return std::nullopt;
      nodes.emplace_back();
    }
  }
  return nodes;
}

void add_ends(const TracedStep& step, const StepPath& path, std::vector<bool>& expressions) {
  for (const StepIndex member : path.members) expressions[member] = true;
  for (const StepOutcome& outcome : path.outcomes) {
    const StepComparison& comparison = step.comparisons[outcome.comparison];
    expressions[comparison.left] = expressions[comparison.right] = true;
  }
}

void add_operands(const TracedStep& step, std::vector<bool>& expressions) {
  for (std::size_t index = expressions.size(); index-- > 0;)
    if (expressions[index])
      for (const StepIndex operand : step.expressions[index].used_operands()) expressions[operand] = true;
}

std::vector<bool> evaluated_by(const TracedStep& step, const StepPath& path) {
  std::vector<bool> evaluated(step.expressions.size());
  add_ends(step, path, evaluated);
  add_operands(step, evaluated);
  return evaluated;
}

}  // namespace hyrax

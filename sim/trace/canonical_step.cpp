#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/trace/decision_tree.h"
#include "sim/trace/numbered.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

constexpr double kLargestSingle = static_cast<double>(std::numeric_limits<float>::max());

// Expressions, each once. A product or quotient is kept apart from its sign.
class SignedExpressions {
 public:
  explicit SignedExpressions(const TracedStep& step) {
    for (const Expression& raw : step.expressions) {
      const Term& term = terms_.emplace_back(term_of(raw));
      const Expression negated{
          .op = Operator::negate, .kind = raw.kind, .operands = {term.index, kNoIndex, kNoIndex}};
      numbers_.push_back(term.is_negative ? table_.number_of(negated) : term.index);
    }
  }

  // By expression of the step: its number here, of a negation if it is negative.
  [[nodiscard]] const std::vector<StepIndex>& numbers() const { return numbers_; }
  [[nodiscard]] const std::vector<Expression>& expressions() const { return table_.items(); }

 private:
  struct Term {
    StepIndex index = kNoIndex;
    bool is_negative = false;
  };

  Term term_of(const Expression& raw) {
    const auto operand = [&](std::size_t place) { return terms_[raw.operands[place]]; };
    const bool has_sign_apart = raw.op == Operator::multiply ||
                                // The quotient of the least int and -1 is no int, so an int's sign stays.
                                (raw.op == Operator::divide && raw.kind != NumberKind::whole);
    if (raw.op == Operator::constant) return constant(raw);
    if (raw.op == Operator::negate) return {operand(0).index, !operand(0).is_negative};
    if (!has_sign_apart) return {table_.number_of(with_operands(raw, numbers_))};
    Expression expression = raw;
    expression.operands = {operand(0).index, operand(1).index, kNoIndex};
    order_operands(expression);
    return {table_.number_of(expression), operand(0).is_negative != operand(1).is_negative};
  }

  Term constant(const Expression& raw) {
    double value = raw.value;
    if (raw.kind == NumberKind::single && std::fabs(value) <= kLargestSingle)
      value = static_cast<double>(static_cast<float>(value));
    if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
    const bool is_negative = raw.kind == NumberKind::whole ? value < 0.0 : std::signbit(value);
    value = std::fabs(value);
    return {table_.number_of({.op = Operator::constant, .kind = raw.kind, .value = value}),
            is_negative && !std::isnan(value)};
  }

  Numbered<Expression> table_;
  std::vector<Term> terms_;  // By expression of the step.
  std::vector<StepIndex> numbers_;
};

// The step with each expression and comparison once, signs moved out; not yet numbered.
TracedStep unique_step(const TracedStep& step) {
  const SignedExpressions table(step);
  Numbered<StepComparison> unique_comparisons;
  std::vector<StepIndex> comparisons;
  for (const StepComparison& raw : step.comparisons)
    comparisons.push_back(unique_comparisons.number_of(with_sides(raw, table.numbers())));
  TracedStep unique = step;
  unique.expressions = table.expressions();
  unique.comparisons = unique_comparisons.items();
  for (std::size_t function = 0; function < step.paths.size(); ++function) {
    unique.paths[function].clear();
    for (const StepPath& raw : step.paths[function]) {
      std::map<StepIndex, bool> outcomes;
      bool is_possible = true;
      for (const auto& [comparison, holds] : raw.outcomes)
        is_possible &= outcomes.try_emplace(comparisons[comparison], holds).first->second == holds;
      if (!is_possible) continue;
      StepPath& path = unique.paths[function].emplace_back();
      for (const auto& [comparison, holds] : outcomes) path.outcomes.push_back({comparison, holds});
      for (const StepIndex member : raw.members) path.members.push_back(table.numbers()[member]);
    }
  }
  return unique;
}

// Appends the items in their order. @param numbers get their new places, by their old ones.
template <class Item>
void append(const std::map<Item, std::size_t>& ordered, std::vector<StepIndex>& numbers,
            std::vector<Item>& items) {
  for (const auto& [item, index] : ordered) {
    numbers[index] = static_cast<StepIndex>(items.size());
    items.push_back(item);
  }
}

// By depth, and in a depth by structure. Returns the new number of each expression of `unique`.
std::vector<StepIndex> number_expressions(const TracedStep& unique, const std::vector<bool>& is_needed,
                                          TracedStep& numbered) {
  const std::size_t count = unique.expressions.size();
  std::vector<std::vector<std::size_t>> levels;
  std::vector<std::size_t> depths(count);
  for (std::size_t index = 0; index < count; ++index) {
    if (!is_needed[index]) continue;
    for (const StepIndex operand : unique.expressions[index].used_operands())
      depths[index] = std::max(depths[index], depths[operand] + 1);
    levels.resize(std::max(levels.size(), depths[index] + 1));
    levels[depths[index]].push_back(index);
  }
  std::vector<StepIndex> numbers(count, kNoIndex);
  for (const std::vector<std::size_t>& level : levels) {
    std::map<Expression, std::size_t> ordered;
    for (const std::size_t index : level)
      ordered.emplace(with_operands(unique.expressions[index], numbers), index);
    append(ordered, numbers, numbered.expressions);
  }
  return numbers;
}

std::vector<StepIndex> number_comparisons(const TracedStep& unique, const std::vector<bool>& is_needed,
                                          const std::vector<StepIndex>& expressions, TracedStep& numbered) {
  std::map<StepComparison, std::size_t> ordered;
  for (std::size_t index = 0; index < unique.comparisons.size(); ++index)
    if (is_needed[index]) ordered.emplace(with_sides(unique.comparisons[index], expressions), index);
  std::vector<StepIndex> numbers(unique.comparisons.size(), kNoIndex);
  append(ordered, numbers, numbered.comparisons);
  return numbers;
}

void sort_paths(std::vector<StepPath>& paths) {
  std::ranges::sort(paths);
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
}

// Merges every two paths that differ in the outcome of this comparison alone into one without it, unless the
// paths are no tree of decisions then. Returns whether any were merged.
bool drop_comparison(std::vector<StepPath>& paths, StepIndex comparison) {
  const auto find_in = [comparison](auto& outcomes) {
    return std::ranges::find(outcomes, comparison, &StepOutcome::comparison);
  };
  const auto is_in_pair = [&](const StepPath& path) {
    if (find_in(path.outcomes) == path.outcomes.end()) return false;
    StepPath other = path;
    find_in(other.outcomes)->holds = !find_in(path.outcomes)->holds;
    return std::ranges::binary_search(paths, other);
  };
  if (std::none_of(paths.begin(), paths.end(), is_in_pair)) return false;
  std::vector<StepPath> merged = paths;
  for (StepPath& path : merged)
    if (is_in_pair(path)) path.outcomes.erase(find_in(path.outcomes));
  sort_paths(merged);
  if (!make_decision_tree(merged)) return false;
  paths = std::move(merged);
  return true;
}

// The last first: of two that could be dropped, but not both, the one that comes first is kept.
bool drop_comparisons(TracedStep& step) {
  bool drops = false;
  for (std::vector<StepPath>& paths : step.paths)
    for (auto comparison = static_cast<StepIndex>(step.comparisons.size()); comparison-- > 0;)
      drops |= drop_comparison(paths, comparison);
  return drops;
}

}  // namespace

TracedStep in_order(const TracedStep& step) {
  const TracedStep unique = unique_step(step);
  std::vector<bool> needed(unique.expressions.size()), decide(unique.comparisons.size());
  for (const std::vector<StepPath>& paths : unique.paths)
    for (const StepPath& path : paths) {
      add_ends(unique, path, needed);
      for (const StepOutcome& outcome : path.outcomes) decide[outcome.comparison] = true;
    }
  add_operands(unique, needed);
  TracedStep numbered = unique;
  numbered.expressions.clear();
  numbered.comparisons.clear();
  const std::vector<StepIndex> expressions = number_expressions(unique, needed, numbered);
  const std::vector<StepIndex> comparisons = number_comparisons(unique, decide, expressions, numbered);
  for (std::vector<StepPath>& paths : numbered.paths) {
    for (StepPath& path : paths) {
      for (StepOutcome& outcome : path.outcomes) outcome.comparison = comparisons[outcome.comparison];
      std::ranges::sort(path.outcomes, {}, &StepOutcome::comparison);
      for (StepIndex& member : path.members) member = expressions[member];
    }
    sort_paths(paths);
  }
  return numbered;
}

TracedStep canonical(const TracedStep& step) {
  TracedStep reduced = in_order(step);
  while (drop_comparisons(reduced)) reduced = in_order(reduced);
  return reduced;
}

}  // namespace hyrax

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/trace/decision_tree.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

constexpr double kLargestSingle = static_cast<double>(std::numeric_limits<float>::max());

// Expressions, each once, in the order in which they are first needed.
class ExpressionTable {
 public:
  // A product or quotient is kept apart from its sign.
  struct Term {
    std::int32_t index = -1;
    bool is_negative = false;
  };

  Term term(const Expression& raw, const std::vector<Term>& terms) {
    const auto operand = [&](std::size_t place) {
      return terms[static_cast<std::size_t>(raw.operands[place])];
    };
    Expression expression{.op = raw.op, .kind = raw.kind};
    switch (raw.op) {
      case Operator::constant:
        return constant(raw);
      case Operator::negate:
        return {operand(0).index, !operand(0).is_negative};
      case Operator::divide:
        // The quotient of the least int and -1 is no int, so an int's sign stays.
        if (raw.kind == NumberKind::whole) break;
        [[fallthrough]];
      case Operator::multiply:
        expression.operands = {operand(0).index, operand(1).index, -1};
        return {index_of(expression), operand(0).is_negative != operand(1).is_negative};
      default:
        break;
    }
    expression.name = raw.name;
    for (std::size_t place = 0; place < raw.operands.size(); ++place)
      if (raw.operands[place] >= 0) expression.operands[place] = plain(operand(place));
    return {index_of(expression), false};
  }

  // The term as an expression, a negation if it is negative.
  std::int32_t plain(const Term& term) {
    if (!term.is_negative) return term.index;
    const NumberKind kind = expressions_[static_cast<std::size_t>(term.index)].kind;
    return index_of({.op = Operator::negate, .kind = kind, .operands = {term.index, -1, -1}});
  }

  [[nodiscard]] const std::vector<Expression>& expressions() const { return expressions_; }

 private:
  Term constant(const Expression& raw) {
    double value = raw.value;
    if (raw.kind == NumberKind::single && std::fabs(value) <= kLargestSingle)
      value = static_cast<double>(static_cast<float>(value));
    if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
    const bool is_negative = raw.kind == NumberKind::whole ? value < 0.0 : std::signbit(value);
    value = std::fabs(value);
    return {index_of({.op = Operator::constant, .kind = raw.kind, .value = value}),
            is_negative && !std::isnan(value)};
  }

  std::int32_t index_of(Expression expression) {
    order_operands(expression);
    const auto [place, is_new] =
        indices_.try_emplace(expression, static_cast<std::int32_t>(expressions_.size()));
    if (is_new) expressions_.push_back(std::move(expression));
    return place->second;
  }

  std::vector<Expression> expressions_;
  std::map<Expression, std::int32_t> indices_;
};

// The step with each expression and comparison once, signs moved out; not yet numbered.
TracedStep unique_step(const TracedStep& step) {
  ExpressionTable table;
  std::vector<ExpressionTable::Term> terms;
  terms.reserve(step.expressions.size());
  for (const Expression& raw : step.expressions) terms.push_back(table.term(raw, terms));
  const auto plain = [&](std::int32_t raw) { return table.plain(terms[static_cast<std::size_t>(raw)]); };

  TracedStep unique{.members = step.members};
  std::map<StepComparison, std::int32_t> indices;
  std::vector<std::int32_t> comparisons;
  for (const StepComparison& raw : step.comparisons) {
    const StepComparison comparison = with_sides({raw.relation, 0, 1}, {plain(raw.left), plain(raw.right)});
    const auto [place, is_new] =
        indices.try_emplace(comparison, static_cast<std::int32_t>(unique.comparisons.size()));
    if (is_new) unique.comparisons.push_back(comparison);
    comparisons.push_back(place->second);
  }
  for (std::size_t function = 0; function < kCoreFunctions; ++function)
    for (const StepPath& raw : step.paths[function]) {
      std::map<std::int32_t, bool> outcomes;
      bool is_possible = true;
      for (const StepOutcome& outcome : raw.outcomes) {
        const std::int32_t comparison = comparisons[static_cast<std::size_t>(outcome.comparison)];
        is_possible &= outcomes.try_emplace(comparison, outcome.holds).first->second == outcome.holds;
      }
      if (!is_possible) continue;
      StepPath& path = unique.paths[function].emplace_back();
      for (const auto& [comparison, holds] : outcomes) path.outcomes.push_back({comparison, holds});
      for (const std::int32_t member : raw.members) path.members.push_back(plain(member));
    }
  unique.expressions = table.expressions();
  return unique;
}

// What the paths need.
struct Needed {
  explicit Needed(const TracedStep& step)
      : expressions(step.expressions.size()), comparisons(step.comparisons.size()) {
    for (const std::vector<StepPath>& paths : step.paths)
      for (const StepPath& path : paths) {
        for (const StepOutcome& outcome : path.outcomes)
          comparisons[static_cast<std::size_t>(outcome.comparison)] = true;
        for (const std::int32_t member : path.members) expressions[static_cast<std::size_t>(member)] = true;
      }
    for (std::size_t index = 0; index < comparisons.size(); ++index)
      if (comparisons[index]) {
        expressions[static_cast<std::size_t>(step.comparisons[index].left)] = true;
        expressions[static_cast<std::size_t>(step.comparisons[index].right)] = true;
      }
    add_operands(step, expressions);
  }
  std::vector<bool> expressions;
  std::vector<bool> comparisons;
};

// By depth, and in a depth by structure. Returns the new number of each expression of `unique`.
std::vector<std::int32_t> number_expressions(const TracedStep& unique, const std::vector<bool>& is_needed,
                                             TracedStep& numbered) {
  const std::size_t count = unique.expressions.size();
  std::vector<std::vector<std::size_t>> levels;
  std::vector<std::size_t> depths(count);
  for (std::size_t index = 0; index < count; ++index) {
    if (!is_needed[index]) continue;
    for (const std::int32_t operand : unique.expressions[index].operands)
      if (operand >= 0)
        depths[index] = std::max(depths[index], depths[static_cast<std::size_t>(operand)] + 1);
    levels.resize(std::max(levels.size(), depths[index] + 1));
    levels[depths[index]].push_back(index);
  }
  std::vector<std::int32_t> numbers(count, -1);
  for (const std::vector<std::size_t>& level : levels) {
    std::vector<std::pair<Expression, std::size_t>> ordered;
    ordered.reserve(level.size());
    for (const std::size_t index : level)
      ordered.emplace_back(with_operands(unique.expressions[index], numbers), index);
    std::sort(ordered.begin(), ordered.end());
    for (auto& [expression, index] : ordered) {
      numbers[index] = static_cast<std::int32_t>(numbered.expressions.size());
      numbered.expressions.push_back(std::move(expression));
    }
  }
  return numbers;
}

std::vector<std::int32_t> number_comparisons(const TracedStep& unique, const std::vector<bool>& is_needed,
                                             const std::vector<std::int32_t>& expressions,
                                             TracedStep& numbered) {
  std::map<StepComparison, std::size_t> ordered;
  for (std::size_t index = 0; index < unique.comparisons.size(); ++index)
    if (is_needed[index]) ordered[with_sides(unique.comparisons[index], expressions)] = index;
  std::vector<std::int32_t> numbers(unique.comparisons.size(), -1);
  for (const auto& [comparison, index] : ordered) {
    numbers[index] = static_cast<std::int32_t>(numbered.comparisons.size());
    numbered.comparisons.push_back(comparison);
  }
  return numbers;
}

bool is_before(const StepPath& a, const StepPath& b) {
  const auto order = [](const StepOutcome& p, const StepOutcome& q) {
    return std::pair(p.comparison, p.holds) < std::pair(q.comparison, q.holds);
  };
  if (a.outcomes != b.outcomes)
    return std::lexicographical_compare(a.outcomes.begin(), a.outcomes.end(), b.outcomes.begin(),
                                        b.outcomes.end(), order);
  return a.members < b.members;
}

void sort_paths(std::vector<StepPath>& paths) {
  std::sort(paths.begin(), paths.end(), is_before);
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
}

// Merges every two paths that differ in the outcome of this comparison alone into one without it, unless the
// paths are no tree of decisions then. Returns whether any were merged.
bool drop_comparison(std::vector<StepPath>& paths, std::int32_t comparison) {
  const auto find_in = [comparison](auto& outcomes) {
    return std::ranges::find(outcomes, comparison, &StepOutcome::comparison);
  };
  const auto is_in_pair = [&](const StepPath& path) {
    if (find_in(path.outcomes) == path.outcomes.end()) return false;
    StepPath other = path;
    find_in(other.outcomes)->holds = !find_in(path.outcomes)->holds;
    return std::binary_search(paths.begin(), paths.end(), other, is_before);
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
    for (auto comparison = static_cast<std::int32_t>(step.comparisons.size()); comparison-- > 0;)
      drops |= drop_comparison(paths, comparison);
  return drops;
}

}  // namespace

TracedStep in_order(const TracedStep& step) {
  const TracedStep unique = unique_step(step);
  const Needed needed(unique);
  TracedStep numbered{.members = step.members};
  const std::vector<std::int32_t> expressions = number_expressions(unique, needed.expressions, numbered);
  const std::vector<std::int32_t> comparisons =
      number_comparisons(unique, needed.comparisons, expressions, numbered);
  for (std::size_t function = 0; function < kCoreFunctions; ++function) {
    std::vector<StepPath>& paths = numbered.paths[function];
    paths = unique.paths[function];
    for (StepPath& path : paths) {
      for (StepOutcome& outcome : path.outcomes)
        outcome.comparison = comparisons[static_cast<std::size_t>(outcome.comparison)];
      std::ranges::sort(path.outcomes, {}, &StepOutcome::comparison);
      for (std::int32_t& member : path.members) member = expressions[static_cast<std::size_t>(member)];
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

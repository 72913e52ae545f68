#include "sim/trace/step_difference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/trace/decision_tree.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

// With the paths of update alone, or with those of all other functions.
TracedStep part_of(TracedStep step, bool is_update) {
  for (std::size_t function = 0; function < kCoreFunctions; ++function)
    if ((static_cast<CoreFunction>(function) == CoreFunction::update) != is_update)
      step.paths[function].clear();
  return canonical(step);
}

// Numbers that two steps share: equal structure, equal number.
class SharedNumbers {
 public:
  std::vector<std::int32_t> expressions_of(const TracedStep& step) {
    std::vector<std::int32_t> numbers;
    for (const Expression& expression : step.expressions) {
      const auto number = static_cast<std::int32_t>(expressions_.size());
      numbers.push_back(expressions_.try_emplace(with_operands(expression, numbers), number).first->second);
    }
    return numbers;
  }

  std::vector<std::int32_t> comparisons_of(const TracedStep& step,
                                           const std::vector<std::int32_t>& expressions) {
    std::vector<std::int32_t> numbers;
    for (const StepComparison& comparison : step.comparisons) {
      const auto number = static_cast<std::int32_t>(comparisons_.size());
      numbers.push_back(comparisons_.try_emplace(with_sides(comparison, expressions), number).first->second);
    }
    return numbers;
  }

 private:
  std::map<Expression, std::int32_t> expressions_;
  std::map<StepComparison, std::int32_t> comparisons_;
};

// One of the two steps, with its numbers among both.
struct Side {
  TracedStep step;
  std::vector<std::int32_t> expressions = {};
  std::vector<std::int32_t> comparisons = {};
  std::set<std::int32_t> has_expressions = {};  // That update evaluates.
  std::set<std::int32_t> has_comparisons = {};
  std::vector<std::vector<bool>> evaluated = {};  // By path, by expression.

  [[nodiscard]] const std::vector<StepPath>& paths() const { return step.paths_of(CoreFunction::update); }
  // Numbers need no other step to have them.
  [[nodiscard]] bool is_number(std::int32_t index) const {
    const Expression& expression = step.expressions[static_cast<std::size_t>(index)];
    return expression.op == Operator::argument || expression.op == Operator::constant ||
           (expression.op == Operator::negate && is_number(expression.operands[0]));
  }
};

Side make_side(const TracedStep& step, SharedNumbers& shared) {
  Side side{.step = step};
  side.expressions = shared.expressions_of(side.step);
  side.comparisons = shared.comparisons_of(side.step, side.expressions);
  std::vector<bool> is_evaluated(step.expressions.size());
  for (const StepPath& path : side.paths()) {
    const std::vector<bool>& evaluated = side.evaluated.emplace_back(evaluated_by(step, path));
    for (std::size_t index = 0; index < evaluated.size(); ++index)
      if (evaluated[index]) is_evaluated[index] = true;
    for (const StepOutcome& outcome : path.outcomes)
      side.has_comparisons.insert(side.comparisons[static_cast<std::size_t>(outcome.comparison)]);
  }
  for (std::size_t index = 0; index < is_evaluated.size(); ++index)
    if (is_evaluated[index]) side.has_expressions.insert(side.expressions[index]);
  return side;
}

// Which NaN arose is no difference.
bool is_same(double p, double q) { return same_bits(p, q) || (std::isnan(p) && std::isnan(q)); }

// Where a row of both results differs.
bool differs(const TracedBody& a, const TracedBody& b) {
  return !(is_same(a.x(), b.x()) && is_same(a.y(), b.y()) && is_same(a.vx(), b.vx()) &&
           is_same(a.vy(), b.vy()));
}

}  // namespace

bool are_further_alike(TracedBody& a, TracedBody& b) {
  return std::ranges::equal(a.further_members(), b.further_members(), is_same);
}

struct StepPair::Data {
  Data(const TracedStep& accepted, const TracedStep& current, const NumberNames& number_names)
      : names(number_names),
        programs{make_step_program(accepted), make_step_program(current)},
        are_setters_equal(part_of(accepted, false) == part_of(current, false)) {
    SharedNumbers shared;
    sides = {make_side(accepted, shared), make_side(current, shared)};
    if (part_of(accepted, true) == part_of(current, true)) return;
    for (std::size_t owner = 0; owner < 2; ++owner) {
      find_comparisons(owner);
      find_expressions(owner);
    }
    find_paths();
    if (differences.empty())
      add(0, {.is_in_accepted = true, .text = "the paths of update"},
          std::vector<bool>(sides[0].paths().size(), true));
  }

  [[nodiscard]] bool is_playable() const { return programs[0] && programs[1]; }

  void add(std::size_t owner, StepDifference difference, std::vector<bool> is_on_path) {
    difference.is_in_accepted = owner == 0;
    differences.push_back(std::move(difference));
    on_paths.push_back(std::move(is_on_path));
  }

  // Whether the other step has it, too.
  [[nodiscard]] bool has_operand(std::size_t owner, std::int32_t index) const {
    return index < 0 || sides[owner].is_number(index) ||
           sides[1 - owner].has_expressions.contains(
               sides[owner].expressions[static_cast<std::size_t>(index)]);
  }

  void find_comparisons(std::size_t owner) {
    const Side& side = sides[owner];
    for (std::size_t index = 0; index < side.comparisons.size(); ++index) {
      const StepComparison& comparison = side.step.comparisons[index];
      if (!side.has_comparisons.contains(side.comparisons[index]) ||
          sides[1 - owner].has_comparisons.contains(side.comparisons[index]) ||
          !has_operand(owner, comparison.left) || !has_operand(owner, comparison.right))
        continue;
      const auto number = static_cast<std::int32_t>(index);
      std::vector<bool> is_on_path;
      for (const StepPath& path : side.paths())
        is_on_path.push_back(std::ranges::find(path.outcomes, number, &StepOutcome::comparison) !=
                             path.outcomes.end());
      add(owner, {.text = comparison_text(side.step, number, names), .is_comparison = true, .index = number},
          std::move(is_on_path));
    }
  }

  void find_expressions(std::size_t owner) {
    const Side& side = sides[owner];
    for (std::size_t index = 0; index < side.expressions.size(); ++index) {
      const auto number = static_cast<std::int32_t>(index);
      const Expression& expression = side.step.expressions[index];
      if (!side.has_expressions.contains(side.expressions[index]) || has_operand(owner, number) ||
          !std::ranges::all_of(expression.operands,
                               [&](std::int32_t operand) { return has_operand(owner, operand); }))
        continue;
      std::vector<bool> is_on_path;
      for (const std::vector<bool>& evaluated : side.evaluated) is_on_path.push_back(evaluated[index]);
      add(owner, {.text = expression_text(side.step, number, names), .index = number}, std::move(is_on_path));
    }
  }

  // Members that become something else where both steps calculate and compare the same.
  void find_paths() {
    const Side& a = sides[0];
    const Side& b = sides[1];
    const std::vector<bool> is_told_a = told_paths(0);
    const std::vector<bool> is_told_b = told_paths(1);
    std::map<std::map<std::int32_t, bool>, std::size_t> paths_b;
    for (std::size_t q = 0; q < b.paths().size(); ++q) paths_b[outcomes_of(b, b.paths()[q])] = q;
    std::map<std::int32_t, std::vector<bool>> found;  // By expression of a.
    const auto compare = [&](std::size_t p, std::size_t q) {
      for (std::size_t member = 0; member < a.step.members.size() && !is_told_b[q]; ++member) {
        const std::int32_t expression = a.paths()[p].members[member];
        if (member < b.step.members.size() &&
            a.expressions[static_cast<std::size_t>(expression)] ==
                b.expressions[static_cast<std::size_t>(b.paths()[q].members[member])])
          continue;
        found.try_emplace(expression, a.paths().size()).first->second[p] = true;
        return;
      }
    };
    for (std::size_t p = 0; p < a.paths().size(); ++p) {
      if (is_told_a[p]) continue;
      const std::map<std::int32_t, bool> outcomes = outcomes_of(a, a.paths()[p]);
      // A path of the same outcomes is the only one that agrees with this one.
      if (const auto same = paths_b.find(outcomes); same != paths_b.end())
        compare(p, same->second);
      else
        for (const auto& [other, q] : paths_b)
          if (agree(outcomes, other)) compare(p, q);
    }
    for (auto& [expression, is_on_path] : found)
      add(0, {.text = expression_text(a.step, expression, names), .index = expression},
          std::move(is_on_path));
  }

  // By path of a side: whether it evaluates a difference that was found.
  [[nodiscard]] std::vector<bool> told_paths(std::size_t owner) const {
    std::vector<bool> told(sides[owner].paths().size());
    for (std::size_t index = 0; index < differences.size(); ++index)
      if (differences[index].is_in_accepted == (owner == 0))
        for (std::size_t path = 0; path < told.size(); ++path)
          if (on_paths[index][path]) told[path] = true;
    return told;
  }

  static std::map<std::int32_t, bool> outcomes_of(const Side& side, const StepPath& path) {
    std::map<std::int32_t, bool> outcomes;
    for (const StepOutcome& outcome : path.outcomes)
      outcomes[side.comparisons[static_cast<std::size_t>(outcome.comparison)]] = outcome.holds;
    return outcomes;
  }

  static bool agree(const std::map<std::int32_t, bool>& a, const std::map<std::int32_t, bool>& b) {
    return std::all_of(a.begin(), a.end(), [&](const auto& outcome) {
      const auto other = b.find(outcome.first);
      return other == b.end() || other->second == outcome.second;
    });
  }

  NumberNames names;
  std::vector<std::shared_ptr<const StepProgram>> programs;
  bool are_setters_equal = false;
  std::array<Side, 2> sides;
  std::vector<StepDifference> differences;
  std::vector<std::vector<bool>> on_paths;  // By difference, by path of the step that has it.
};

StepPair::StepPair(const TracedStep& accepted, const TracedStep& current, const NumberNames& names)
    : data_(std::make_unique<Data>(accepted, current, names)) {}
StepPair::~StepPair() = default;

const std::vector<StepDifference>& StepPair::differences() const { return data_->differences; }
bool StepPair::are_setters_equal() const { return data_->are_setters_equal; }

const std::vector<std::shared_ptr<const StepProgram>>& StepPair::programs() const { return data_->programs; }

bool StepPair::notice(const StepInput& input, std::span<TracedBody> bodies, std::vector<bool>& evaluated,
                      std::vector<bool>& noticed) const {
  assert(noticed.size() == differences().size() && evaluated.size() == noticed.size());
  if (bodies.size() < 2) return false;
  TracedBody& a = bodies[0];
  TracedBody& b = bodies[1];
  a.update(input);
  b.update(input);
  const bool is_other_row = differs(a, b);
  const bool is_over = are_further_alike(a, b);
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    const std::int32_t path = differences()[index].is_in_accepted ? a.path() : b.path();
    if (data_->on_paths[index][static_cast<std::size_t>(path)]) evaluated[index] = true;
    if (is_other_row && evaluated[index]) noticed[index] = true;
    if (is_over) evaluated[index] = false;
  }
  return is_other_row;
}

DifferenceSearch StepPair::search(std::size_t difference, std::uint64_t seed, std::int64_t steps_max) const {
  if (!data_->is_playable()) return {};
  const StepDifference& wanted = differences()[difference];
  const std::size_t owner = wanted.is_in_accepted ? 0 : 1;
  return search_difference({.owner = data_->programs[owner].get(),
                            .other = data_->programs[1 - owner].get(),
                            .is_in_accepted = wanted.is_in_accepted,
                            .is_on_path = data_->on_paths[difference],
                            .comparison = wanted.is_comparison ? wanted.index : -1},
                           seed, steps_max);
}

}  // namespace hyrax

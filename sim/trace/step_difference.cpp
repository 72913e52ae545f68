#include "sim/trace/step_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/trace/decision_tree.h"
#include "sim/trace/numbered.h"
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

// Which NaN arose is no difference.
bool is_same(double p, double q) { return same_bits(p, q) || (std::isnan(p) && std::isnan(q)); }

// Where a row of both results differs.
bool differs(const TracedBody& a, const TracedBody& b) {
  return !(is_same(a.x(), b.x()) && is_same(a.y(), b.y()) && is_same(a.vx(), b.vx()) &&
           is_same(a.vy(), b.vy()));
}

using Outcomes = std::map<StepIndex, bool>;  // By number of a comparison among both steps.

bool agree(const Outcomes& a, const Outcomes& b) {
  return std::ranges::all_of(a, [&](const auto& outcome) {
    const auto other = b.find(outcome.first);
    return other == b.end() || other->second == outcome.second;
  });
}

// One of the two steps, with its numbers among both.
struct Side {
  Side(const TracedStep& traced, SharedNumbers& shared) : step(traced), numbers(shared.of(traced)) {
    std::vector<bool> needed(step.expressions.size());
    for (const StepPath& path : paths()) {
      evaluated.push_back(evaluated_by(step, path));
      add_ends(step, path, needed);
      for (const StepOutcome& outcome : path.outcomes)
        has_comparisons.insert(numbers.comparisons[outcome.comparison]);
    }
    add_operands(step, needed);
    for (std::size_t index = 0; index < needed.size(); ++index)
      if (needed[index]) has_expressions.insert(numbers.expressions[index]);
  }

  [[nodiscard]] const std::vector<StepPath>& paths() const { return step.paths_of(CoreFunction::update); }
  // Numbers need no other step to have them.
  [[nodiscard]] bool is_number(StepIndex index) const {
    const Expression& expression = step.expressions[index];
    return expression.op == Operator::argument || expression.op == Operator::constant ||
           (expression.op == Operator::negate && is_number(expression.operands[0]));
  }
  [[nodiscard]] Outcomes outcomes_of(const StepPath& path) const {
    Outcomes outcomes;
    for (const auto& [comparison, holds] : path.outcomes) outcomes[numbers.comparisons[comparison]] = holds;
    return outcomes;
  }

  const TracedStep& step;
  SharedNumbers::OfStep numbers;
  std::set<StepIndex> has_expressions;  // That update evaluates.
  std::set<StepIndex> has_comparisons;
  std::vector<std::vector<bool>> evaluated;  // By path, by expression.
};

class DifferenceFinder {
 public:
  DifferenceFinder(const TracedStep& accepted, const TracedStep& current, const NumberNames& names)
      : names_(names), accepted_(accepted, shared_), current_(current, shared_) {}

  std::vector<StepDifference> find() {
    for (const auto& [side, other] : {std::pair(&accepted_, &current_), std::pair(&current_, &accepted_)}) {
      find_comparisons(*side, *other);
      find_expressions(*side, *other);
    }
    find_paths();
    if (found_.empty())
      add(accepted_, "the paths of update", std::vector<bool>(accepted_.paths().size(), true));
    return std::move(found_);
  }

 private:
  void add(const Side& side, const std::string& text, std::vector<bool> is_on_path,
           StepIndex comparison = kNoIndex) {
    found_.push_back({&side == &accepted_, text, std::move(is_on_path), comparison});
  }

  // Whether the other step has it, too.
  static bool has_operand(const Side& side, const Side& other, StepIndex index) {
    return side.is_number(index) || other.has_expressions.contains(side.numbers.expressions[index]);
  }

  void find_comparisons(const Side& side, const Side& other) {
    for (StepIndex index = 0; index < side.step.comparisons.size(); ++index) {
      const StepComparison& comparison = side.step.comparisons[index];
      const StepIndex number = side.numbers.comparisons[index];
      if (!side.has_comparisons.contains(number) || other.has_comparisons.contains(number) ||
          !has_operand(side, other, comparison.left) || !has_operand(side, other, comparison.right))
        continue;
      std::vector<bool> is_on_path;
      for (const StepPath& path : side.paths())
        is_on_path.push_back(std::ranges::find(path.outcomes, index, &StepOutcome::comparison) !=
                             path.outcomes.end());
      add(side, comparison_text(side.step, index, names_), std::move(is_on_path), index);
    }
  }

  void find_expressions(const Side& side, const Side& other) {
    for (StepIndex index = 0; index < side.step.expressions.size(); ++index) {
      const auto is_known = [&](StepIndex operand) { return has_operand(side, other, operand); };
      if (!side.has_expressions.contains(side.numbers.expressions[index]) || is_known(index) ||
          !std::ranges::all_of(side.step.expressions[index].used_operands(), is_known))
        continue;
      std::vector<bool> is_on_path;
      for (const std::vector<bool>& evaluated : side.evaluated) is_on_path.push_back(evaluated[index]);
      add(side, expression_text(side.step, index, names_), std::move(is_on_path));
    }
  }

  // Members that become something else where both steps calculate and compare the same.
  void find_paths() {
    const Side& a = accepted_;
    const Side& b = current_;
    const std::vector<bool> is_told_a = told_paths(a);
    const std::vector<bool> is_told_b = told_paths(b);
    std::map<Outcomes, std::size_t> paths_b;
    for (std::size_t q = 0; q < b.paths().size(); ++q) paths_b[b.outcomes_of(b.paths()[q])] = q;
    std::map<StepIndex, std::vector<bool>> found;  // By expression of a.
    const auto compare = [&](std::size_t p, std::size_t q) {
      for (std::size_t member = 0; member < a.step.members.size() && !is_told_b[q]; ++member) {
        const StepIndex expression = a.paths()[p].members[member];
        if (member < b.step.members.size() &&
            a.numbers.expressions[expression] == b.numbers.expressions[b.paths()[q].members[member]])
          continue;
        found.try_emplace(expression, a.paths().size()).first->second[p] = true;
        return;
      }
    };
    for (std::size_t p = 0; p < a.paths().size(); ++p) {
      if (is_told_a[p]) continue;
      const Outcomes outcomes = a.outcomes_of(a.paths()[p]);
      // A path of the same outcomes is the only one that agrees with this one.
      if (const auto same = paths_b.find(outcomes); same != paths_b.end())
        compare(p, same->second);
      else
        for (const auto& [other, q] : paths_b)
          if (agree(outcomes, other)) compare(p, q);
    }
    for (auto& [expression, is_on_path] : found)
      add(a, expression_text(a.step, expression, names_), std::move(is_on_path));
  }

  // By path of a side: whether it evaluates a difference that was found.
  [[nodiscard]] std::vector<bool> told_paths(const Side& side) const {
    std::vector<bool> told(side.paths().size());
    for (const StepDifference& difference : found_)
      if (difference.is_in_accepted == (&side == &accepted_))
        for (std::size_t path = 0; path < told.size(); ++path)
          if (difference.is_on_path[path]) told[path] = true;
    return told;
  }

  const NumberNames& names_;
  SharedNumbers shared_;
  Side accepted_;
  Side current_;
  std::vector<StepDifference> found_;
};

}  // namespace

bool are_further_alike(TracedBody& a, TracedBody& b) {
  return std::ranges::equal(a.further_members(), b.further_members(), is_same);
}

StepPair::StepPair(const TracedStep& accepted, const TracedStep& current, const NumberNames& names)
    : programs_{make_step_program(accepted), make_step_program(current)},
      are_setters_equal_(part_of(accepted, false) == part_of(current, false)) {
  if (part_of(accepted, true) != part_of(current, true))
    differences_ = DifferenceFinder(accepted, current, names).find();
}

bool StepPair::notice(const StepInput& input, std::span<TracedBody> bodies, std::vector<bool>& evaluated,
                      std::vector<bool>& noticed) const {
  assert(noticed.size() == differences_.size() && evaluated.size() == noticed.size());
  if (bodies.size() < 2) return false;
  TracedBody& a = bodies[0];
  TracedBody& b = bodies[1];
  a.update(input);
  b.update(input);
  const bool is_other_row = differs(a, b);
  const bool is_over = are_further_alike(a, b);
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    const StepDifference& difference = differences_[index];
    if (difference.is_on_path[(difference.is_in_accepted ? a : b).path()]) evaluated[index] = true;
    if (is_other_row && evaluated[index]) noticed[index] = true;
    if (is_over) evaluated[index] = false;
  }
  return is_other_row;
}

}  // namespace hyrax

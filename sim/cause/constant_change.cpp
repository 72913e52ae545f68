#include "sim/cause/constant_change.h"

#include <cmath>

#include "sim/trace/step_text.h"

namespace hyrax {

TracedStep with_constant(const TracedStep& step, double from, double to) {
  // Constants are never negative: of a negative one the step has the negation.
  const double value = std::signbit(from) ? -to : to;
  TracedStep changed = step;
  changed.expressions.clear();
  std::vector<std::int32_t> moved;  // Where each expression is now.
  const auto place_of = [&](std::int32_t index) {
    return index < 0 ? index : moved[static_cast<std::size_t>(index)];
  };
  const auto add = [&](const Expression& expression) {
    changed.expressions.push_back(expression);
    return static_cast<std::int32_t>(changed.expressions.size()) - 1;
  };
  for (Expression expression : step.expressions) {
    for (std::int32_t& operand : expression.operands) operand = place_of(operand);
    const bool is_changed = expression.op == Operator::constant && expression.value == std::fabs(from);
    if (is_changed) expression.value = std::fabs(value);
    moved.push_back(add(expression));
    if (!is_changed || !std::signbit(value)) continue;
    moved.back() = add(
        {.op = Operator::negate, .kind = expression.kind, .operands = {moved.back(), -1, -1}, .name = {}});
  }
  for (StepComparison& comparison : changed.comparisons) {
    comparison.left = place_of(comparison.left);
    comparison.right = place_of(comparison.right);
  }
  for (auto& paths : changed.paths)
    for (StepPath& path : paths)
      for (std::int32_t& member : path.members) member = place_of(member);
  return canonical(changed);
}

}  // namespace hyrax

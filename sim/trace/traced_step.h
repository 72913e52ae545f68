// The step of a core as data: the paths through it, and what each makes of every member.
//
// A second compilation of the core's header with numbers that record what is done to them makes it
// (sim/trace/host). Paths, comparisons and expressions are those of the header's own operations, each a
// rounded IEEE-754 operation; nothing of the paper's listing is presumed.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/trace/operation.h"

namespace hyrax {

/// One operation on the results of others, which come before it in TracedStep::expressions. Operands are of
/// the operation's kind, except of conversions and functions. A constant int is -2^31 .. 2^31.
struct Expression {
  Operator op = Operator::constant;
  NumberKind kind = NumberKind::real;
  std::array<StepIndex, 3> operands = {kNoIndex, kNoIndex, kNoIndex};  ///< Of expressions; see used_operands.
  double value = 0.0;                                                  ///< Of a constant.
  std::string name = {};                                               ///< Of an argument or a function.

  [[nodiscard]] std::span<const StepIndex> used_operands() const {
    return {operands.begin(), std::ranges::find(operands, kNoIndex)};
  }
  /// Constants by their bits, which for numbers >= 0 is their order: 0.0 is not -0.0.
  std::strong_ordering operator<=>(const Expression& other) const {
    const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
    if (const auto order = std::tie(op, kind, name) <=> std::tie(other.op, other.kind, other.name);
        std::is_neq(order))
      return order;
    return std::tuple(bits(value), operands) <=> std::tuple(bits(other.value), other.operands);
  }
  bool operator==(const Expression& other) const { return std::is_eq(*this <=> other); }
};

constexpr bool is_commutative(Operator op) { return op == Operator::add || op == Operator::multiply; }

inline void order_operands(Expression& expression) {
  if (is_commutative(expression.op) && expression.operands[1] < expression.operands[0])
    std::swap(expression.operands[0], expression.operands[1]);
}

/// The expression over other numbers of its operands, those of a sum or a product in their order.
[[nodiscard]] inline Expression with_operands(Expression expression, const std::vector<StepIndex>& numbers) {
  for (StepIndex& operand : expression.operands)
    if (operand != kNoIndex) operand = numbers[operand];
  order_operands(expression);
  return expression;
}

/// left < right, left <= right or left == right. `a > b` is `b < a`; `a != b` is `a == b` of the other
/// outcome. Both sides are of one kind.
struct StepComparison {
  StepIndex left = kNoIndex;  ///< Of expressions.
  StepIndex right = kNoIndex;
  Relation relation = Relation::less;
  auto operator<=>(const StepComparison&) const = default;  // NOLINT(modernize-use-nullptr): there is no 0.
};

/// The comparison of expressions of other numbers, those of an equality in their order.
[[nodiscard]] inline StepComparison with_sides(StepComparison comparison,
                                               const std::vector<StepIndex>& numbers) {
  comparison.left = numbers[comparison.left];
  comparison.right = numbers[comparison.right];
  if (comparison.relation == Relation::equal && comparison.right < comparison.left)
    std::swap(comparison.left, comparison.right);
  return comparison;
}

/// What one comparison was found to be on a path.
struct StepOutcome {
  StepIndex comparison = kNoIndex;  ///< In TracedStep::comparisons.
  bool holds = false;
  auto operator<=>(const StepOutcome&) const = default;  // NOLINT(modernize-use-nullptr): there is no 0.
};

/// One way through a function: taken where all outcomes are as here.
struct StepPath {
  std::vector<StepOutcome> outcomes;  ///< In the order in which they were made; each comparison once.
  std::vector<StepIndex> members;     ///< The expression of every member at the end.
  auto operator<=>(const StepPath&) const = default;  // NOLINT(modernize-use-nullptr): there is no 0.
};

inline constexpr std::size_t kCoreFunctions = 5;
inline constexpr std::array<std::string_view, kCoreFunctions> kCoreFunctionNames = {
    "construct", "update", "set_position", "set_velocity", "reset_velocity"};

/// Arguments in the order in which a function takes them; those of update are dt and the four sizes.
inline constexpr std::size_t kStepArgumentsMax = 5;
inline constexpr std::array<std::array<std::string_view, kStepArgumentsMax>, kCoreFunctions> kArgumentNames =
    {{{"start_x", "start_y", "start_vx", "start_vy"},
      {"dt", "window_width", "window_height", "sprite_width", "sprite_height"},
      {"new_x", "new_y"},
      {"new_vx", "new_vy"},
      {}}};

/// The name of a member before a call, by its place in TracedStep::members.
[[nodiscard]] inline std::string member_name(std::size_t member) {
  constexpr std::array<const char*, 4> kNames = {"x", "y", "vx", "vy"};
  return member < kNames.size() ? kNames[member] : "member_" + std::to_string(member + 1);
}

/// More paths than this make a step incomplete, over all functions.
inline constexpr std::size_t kStepPathsMax = 4096;
/// More members than this make a step incomplete.
inline constexpr std::size_t kStepMembersMax = 32;
/// More contacts than this make the step of a core that describes itself incomplete.
inline constexpr std::size_t kStepContactsMax = 32;

/// All paths of all functions of a core.
struct TracedStep {
  std::vector<NumberKind> members;  ///< x, y, vx, vy, then further ones in the order of the object's memory.
  std::vector<Expression> expressions = {};
  std::vector<StepComparison> comparisons = {};
  std::vector<std::vector<StepPath>> paths = std::vector<std::vector<StepPath>>(kCoreFunctions);
  ///< By CoreFunction.
  /// Of a core that describes itself, else empty: its values (parameters, inputs, state) and contacts, which
  /// are its members, and its functions, as "step", "strike(vx_px_per_s)", in the order of `paths`. An
  /// argument has the name of its value, of "dt", or of the function, as "strike(vx_px_per_s)".
  std::vector<std::string> member_names = {};
  std::vector<std::string> function_names = {};
  bool operator==(const TracedStep&) const = default;

  [[nodiscard]] bool describes_itself() const { return !member_names.empty(); }

  [[nodiscard]] const std::vector<StepPath>& paths_of(CoreFunction function) const {
    return paths[static_cast<std::size_t>(function)];
  }
};

}  // namespace hyrax

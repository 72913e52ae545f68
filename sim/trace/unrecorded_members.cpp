#include <algorithm>

#include "sim/trace/step_difference.h"

namespace hyrax {
namespace {

// Of a step of more paths, every member is taken to be recorded.
constexpr std::size_t kPathsMax = 512;

// By expression: whether the member before the call is a part of it.
std::vector<bool> parts_of(const TracedStep& step, std::size_t member) {
  std::vector<bool> is_part(step.expressions.size());
  for (StepIndex index = 0; index < is_part.size(); ++index) {
    const Expression& expression = step.expressions[index];
    is_part[index] =
        (expression.op == Operator::argument && expression.name == member_name(member)) ||
        std::ranges::any_of(expression.used_operands(), [&](StepIndex operand) { return is_part[operand]; });
  }
  return is_part;
}

// Whether one of these members ends with another expression on both paths.
bool end_otherwise(const StepPath& a, const StepPath& b, MemberBits members) {
  for (std::size_t member = 0; member < a.members.size(); ++member)
    if ((members >> member & 1u) != 0 && a.members[member] != b.members[member]) return true;
  return false;
}

// Whether the paths part at these comparisons alone.
bool part_at(const std::vector<bool>& comparisons, const StepPath& a, const StepPath& b) {
  bool is_parted = false;
  for (const auto& [comparison, holds] : a.outcomes) {
    const auto other = std::ranges::find(b.outcomes, comparison, &StepOutcome::comparison);
    if (other == b.outcomes.end() || other->holds == holds) continue;
    if (!comparisons[comparison]) return false;
    is_parted = true;
  }
  return is_parted;
}

// Whether one of `members` depends on a member: it is a part of its end, or decides between two ends.
bool reaches(const TracedStep& step, const std::vector<StepPath>& paths, std::size_t member,
             MemberBits members) {
  const std::vector<bool> is_part = parts_of(step, member);
  std::vector<bool> is_compared;
  for (const StepComparison& comparison : step.comparisons)
    is_compared.push_back(is_part[comparison.left] || is_part[comparison.right]);
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    for (std::size_t end = 0; end < path->members.size(); ++end)
      if ((members >> end & 1u) != 0 && is_part[path->members[end]]) return true;
    if (std::any_of(paths.begin(), path, [&](const StepPath& other) {
          return end_otherwise(*path, other, members) && part_at(is_compared, *path, other);
        }))
      return true;
  }
  return false;
}

}  // namespace

MemberBits unrecorded_members(const TracedStep& step) {
  MemberBits recorded = 0b1111;  // x, y, vx, vy; then what they depend on, and what that does.
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (std::size_t member = 0; member < step.members.size(); ++member)
      for (std::size_t function = 0; function < kCoreFunctions; ++function) {
        if ((recorded >> member & 1u) != 0) break;
        const std::vector<StepPath>& paths = step.paths[function];
        if (paths.size() <= kPathsMax && !reaches(step, paths, member, recorded)) continue;
        recorded |= MemberBits{1} << member;
        is_new = true;
      }
  }
  return ~recorded;
}

}  // namespace hyrax

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

constexpr auto kUpdate = static_cast<std::size_t>(CoreFunction::update);

// With the paths of one function alone, or with those of all others.
TracedStep part_of(TracedStep step, bool is_alone, std::size_t function = kUpdate) {
  for (std::size_t other = 0; other < step.paths.size(); ++other)
    if ((other == function) != is_alone) step.paths[other].clear();
  return canonical(step);
}

// Which NaN arose is no difference.
bool is_same(double p, double q) { return same_bits(p, q) || (std::isnan(p) && std::isnan(q)); }

// Members that a row shows.
constexpr MemberBits kRowMembers = 0b1111;
constexpr MemberBits kAllMembers = ~MemberBits{0};

// Members of both bodies that are not the same, and those that only one of them has.
MemberBits differing_members(BodyPair& bodies) {
  const std::span<double> own = bodies.own.members(), other = bodies.other.members();
  MemberBits bits = 0;
  for (std::size_t member = 0; member < std::max(own.size(), other.size()); ++member)
    if (member >= std::min(own.size(), other.size()) || !is_same(own[member], other[member]))
      bits |= MemberBits{1} << member;
  return bits;
}

// Of these members of `own`: those that are nearer to `other` in `changed`.
MemberBits nearer_members(MemberBits members, std::span<double> changed, BodyPair& bodies) {
  const std::span<double> own = bodies.own.members(), other = bodies.other.members();
  MemberBits bits = 0;
  for (std::size_t member = 0; member < std::min(own.size(), other.size()); ++member) {
    const double far = std::fabs(own[member] - other[member]);
    const double near = std::fabs(changed[member] - other[member]);
    const bool is_nearer =
        is_same(changed[member], other[member]) || near < far || (std::isnan(far) && !std::isnan(near));
    if ((members >> member & 1u) != 0 && is_nearer) bits |= MemberBits{1} << member;
  }
  return bits;
}

using PathOutcomes = std::map<StepIndex, bool>;  // By number of a comparison among both steps.

bool agree(const PathOutcomes& a, const PathOutcomes& b) {
  return std::ranges::all_of(a, [&](const auto& outcome) {
    const auto other = b.find(outcome.first);
    return other == b.end() || other->second == outcome.second;
  });
}

// One of the two steps, with its numbers among both.
struct Side {
  Side(const TracedStep& traced, std::size_t of_function, SharedNumbers& shared)
      : step(traced), function(of_function), numbers(shared.of(traced)) {
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

  [[nodiscard]] const std::vector<StepPath>& paths() const { return step.paths[function]; }
  // Numbers need no other step to have them.
  [[nodiscard]] bool is_number(StepIndex index) const {
    const Expression& expression = step.expressions[index];
    return expression.op == Operator::argument || expression.op == Operator::constant ||
           (expression.op == Operator::negate && is_number(expression.operands[0]));
  }
  [[nodiscard]] PathOutcomes outcomes_of(const StepPath& path) const {
    PathOutcomes outcomes;
    for (const auto& [comparison, holds] : path.outcomes) outcomes[numbers.comparisons[comparison]] = holds;
    return outcomes;
  }

  const TracedStep& step;
  const std::size_t function;
  SharedNumbers::OfStep numbers;
  std::set<StepIndex> has_expressions;  // That the function evaluates.
  std::set<StepIndex> has_comparisons;
  std::vector<std::vector<bool>> evaluated;  // By path, by expression.
};

// Of a step of more paths, that a difference is evaluated must do.
constexpr std::size_t kExchangedPathsMax = 512;

// The step with the outcomes of a comparison exchanged, in update.
std::shared_ptr<const StepProgram> with_outcomes_exchanged(TracedStep step, StepIndex comparison) {
  for (StepPath& path : step.paths[kUpdate])
    for (StepOutcome& outcome : path.outcomes)
      if (outcome.comparison == comparison) outcome.holds = !outcome.holds;
  return make_step_program(canonical(step));
}

class DifferenceFinder {
 public:
  DifferenceFinder(const TracedStep& accepted, const TracedStep& current, const NumberNames& names,
                   std::size_t function = kUpdate)
      : names_(names), accepted_(accepted, function, shared_), current_(current, function, shared_) {}

  std::vector<StepDifference> find() {
    for (const auto& [side, other] : {std::pair(&accepted_, &current_), std::pair(&current_, &accepted_)}) {
      find_comparisons(*side, *other);
      find_expressions(*side, *other);
    }
    find_paths();
    if (found_.empty())
      add(accepted_,
          "the paths of " + (accepted_.step.describes_itself()
                                 ? accepted_.step.function_names[accepted_.function]
                                 : std::string(kCoreFunctionNames[kUpdate])),
          std::vector<bool>(accepted_.paths().size(), true));
    return std::move(found_);
  }

 private:
  // A difference of these paths that, until set_effects, may change every member.
  StepDifference& add(const Side& side, const std::string& text, std::vector<bool> is_on_path,
                      StepIndex comparison = kNoIndex) {
    const std::size_t paths = is_on_path.size();
    found_.push_back({&side == &accepted_, text, std::move(is_on_path), comparison,
                      std::vector<MemberBits>(paths, kAllMembers)});
    return found_.back();
  }

  // What a difference can change: on each path the members whose expressions contain it, and the outcomes of
  // comparisons that contain it, exchanged to see what follows. Of a step of very many paths it stays open.
  // @param is_part by expression, @param is_compared by comparison of the side's step: whether it contains
  // it.
  void set_effects(const Side& side, const std::vector<bool>& is_part, const std::vector<bool>& is_compared,
                   StepDifference& difference) {
    if (side.paths().size() > kExchangedPathsMax) return;
    for (std::size_t path = 0; path < side.paths().size(); ++path) {
      difference.members[path] = 0;
      for (std::size_t member = 0; member < side.step.members.size(); ++member)
        if (is_part[side.paths()[path].members[member]]) difference.members[path] |= MemberBits{1} << member;
    }
    for (StepIndex index = 0; index < side.step.comparisons.size(); ++index) {
      if (side.step.describes_itself()) break;  // It is not played.
      if (!is_compared[index] || !side.has_comparisons.contains(side.numbers.comparisons[index])) continue;
      auto& exchanged = exchanged_[&side == &accepted_ ? 0 : 1][index];
      if (!exchanged) exchanged = with_outcomes_exchanged(side.step, index);
      if (exchanged) difference.exchanged.push_back(exchanged);
    }
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
      std::vector<bool> is_compared(side.step.comparisons.size());
      is_compared[index] = true;
      set_effects(side, std::vector<bool>(side.step.expressions.size()), is_compared,
                  add(side, comparison_text(side.step, index, names_), std::move(is_on_path), index));
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
      std::vector<bool> is_part(side.step.expressions.size()), is_compared;
      for (StepIndex user = index; user < is_part.size(); ++user)
        is_part[user] = user == index || std::ranges::any_of(side.step.expressions[user].used_operands(),
                                                             [&](StepIndex part) { return is_part[part]; });
      for (const StepComparison& comparison : side.step.comparisons)
        is_compared.push_back(is_part[comparison.left] || is_part[comparison.right]);
      set_effects(side, is_part, is_compared,
                  add(side, expression_text(side.step, index, names_), std::move(is_on_path)));
    }
  }

  // Members that become something else where both steps calculate and compare the same.
  void find_paths() {
    const Side& a = accepted_;
    const Side& b = current_;
    const std::vector<bool> is_told_a = told_paths(a);
    const std::vector<bool> is_told_b = told_paths(b);
    std::map<PathOutcomes, std::size_t> paths_b;
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
      const PathOutcomes outcomes = a.outcomes_of(a.paths()[p]);
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
  std::array<std::map<StepIndex, std::shared_ptr<const StepProgram>>, 2> exchanged_;  // Of each side.
};

}  // namespace

bool DifferenceWatch::take(const StepDifference& difference, const StepInput& input, BodyPair before,
                           BodyPair after) {
  const MemberBits differing = differing_members(after);
  MemberBits decided = 0;
  const StepIndex path = after.own.path();
  if (differing != 0 && difference.is_on_path[path]) {
    decided = differing & difference.members[path];
    for (const std::shared_ptr<const StepProgram>& exchanged : difference.exchanged) {
      TracedBody changed(*exchanged, {});
      std::ranges::copy(before.own.members(), changed.members().begin());
      changed.update(input);
      decided |= nearer_members(differing, changed.members(), after);
    }
  }
  if (further_ != 0 && differing != 0) {
    TracedBody changed = before.own;
    const std::span<double> own = changed.members(), other = before.other.members();
    for (std::size_t member = 0; member < std::min(own.size(), other.size()); ++member)
      if ((further_ >> member & 1u) != 0) own[member] = other[member];
    changed.update(input);
    decided |= nearer_members(differing, changed.members(), after);
  }
  further_ = (further_ | decided) & differing & ~kRowMembers;
  return (decided & kRowMembers) != 0;
}

std::vector<ValueDifference> value_differences(const TracedStep& accepted, const TracedStep& current,
                                               const NumberNames& names) {
  std::vector<ValueDifference> differences;
  for (std::size_t function = 0; function < accepted.paths.size(); ++function) {
    if (part_of(accepted, true, function) == part_of(current, true, function)) continue;
    std::map<MemberBits, ValueDifference> by_members;
    for (const StepDifference& found : DifferenceFinder(accepted, current, names, function).find()) {
      MemberBits members = 0;
      for (std::size_t path = 0; path < found.members.size(); ++path)
        if (found.is_on_path[path]) members |= found.members[path];
      ValueDifference& difference = by_members[members];
      (found.is_in_accepted ? difference.before : difference.after).push_back(found.text);
    }
    for (auto& [members, difference] : by_members) {
      difference.function = accepted.function_names[function];
      for (std::size_t member = 0; member < accepted.members.size(); ++member)
        if (members != kAllMembers && (members >> member & 1u) != 0)
          difference.values.push_back(accepted.member_names[member]);
      differences.push_back(std::move(difference));
    }
  }
  return differences;
}

StepPair::StepPair(const TracedStep& accepted, const TracedStep& current, const NumberNames& names)
    : programs_{make_step_program(accepted), make_step_program(current)},
      are_setters_equal_(part_of(accepted, false) == part_of(current, false)),
      unrecorded_(unrecorded_members(accepted) & unrecorded_members(current)) {
  if (part_of(accepted, true) != part_of(current, true))
    differences_ = DifferenceFinder(accepted, current, names).find();
}

void StepPair::notice(const StepInput& input, std::span<TracedBody> bodies,
                      std::vector<DifferenceWatch>& watches, std::vector<bool>& noticed) const {
  assert(noticed.size() == differences_.size() && watches.size() == noticed.size());
  if (bodies.size() < 2) return;
  const BodyPair before{bodies[0], bodies[1]};
  for (TracedBody& body : bodies) body.update(input);
  for (std::size_t index = 0; index < noticed.size(); ++index) {
    const StepDifference& difference = differences_[index];
    const auto ordered = [&](const TracedBody& accepted, const TracedBody& current) {
      return difference.is_in_accepted ? BodyPair{accepted, current} : BodyPair{current, accepted};
    };
    if (!noticed[index])
      noticed[index] = watches[index].take(difference, input, ordered(before.own, before.other),
                                           ordered(bodies[0], bodies[1]));
  }
}

}  // namespace hyrax

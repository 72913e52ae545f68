#include "sim/trace/host/recorder.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

namespace hyrax::trace {
namespace {

struct Recorder {
  Numbered<Expression> expressions;
  Numbered<StepComparison> comparisons;
  std::vector<StepOutcome> planned;
  bool others_hold = false;
  std::vector<StepOutcome> outcomes;
  std::map<StepComparison, bool> known;  // On this path.
};

Recorder recorder;
StopHandler stop_handler = nullptr;

Index index_of(const Expression& expression) {
  const Index index = recorder.expressions.number_of(expression);
  if (index >= kExpressionsMax) stop("over its limits: more than 100,000 operations");
  return index;
}

std::optional<bool> known(Relation relation, Index left, Index right) {
  const auto outcome = recorder.known.find({left, right, relation});
  if (outcome == recorder.known.end()) return std::nullopt;
  return outcome->second;
}

// Never NaN.
bool is_whole(Index index) {
  const Expression& expression = recorder.expressions.items()[index];
  return expression.kind == NumberKind::whole ||
         (expression.op == Operator::to_real && is_whole(expression.operands[0]));
}

// What other comparisons of the same two numbers say. NaN makes all of them false.
std::optional<bool> implied(Relation relation, Index left, Index right) {
  if (left == right && is_whole(left)) return relation != Relation::less;
  const auto holds = [](Relation other, Index a, Index b) { return known(other, a, b).value_or(false); };
  const auto are_equal = [&] {
    return holds(Relation::equal, left, right) || holds(Relation::equal, right, left);
  };
  const bool is_less = holds(Relation::less, left, right);
  const bool is_greater = holds(Relation::less, right, left);
  switch (relation) {
    case Relation::less:
      if (is_greater || are_equal() || holds(Relation::less_or_equal, right, left)) return false;
      if (!known(Relation::less_or_equal, left, right).value_or(true)) return false;
      return std::nullopt;
    case Relation::less_or_equal:
      if (is_less || are_equal()) return true;
      if (is_greater) return false;
      return std::nullopt;
    case Relation::equal:
      if (is_less || is_greater) return false;
      if (!known(Relation::less_or_equal, left, right).value_or(true)) return false;
      if (!known(Relation::less_or_equal, right, left).value_or(true)) return false;
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

const std::vector<Expression>& recorded_expressions() { return recorder.expressions.items(); }
const std::vector<StepComparison>& recorded_comparisons() { return recorder.comparisons.items(); }

void start_recording() { recorder = {}; }

void start_path(std::vector<StepOutcome> planned, bool others_hold) {
  recorder.others_hold = others_hold;
  recorder.planned = std::move(planned);
  recorder.outcomes.clear();
  recorder.known.clear();
}

std::vector<StepPath> paths_of(const std::function<std::vector<Index>()>& run, std::size_t& count) {
  std::vector<StepPath> paths;
  std::vector<std::vector<StepOutcome>> to_do = {{}};
  while (!to_do.empty()) {
    if (++count > kStepPathsMax) stop(kTooManyPaths);
    const std::size_t planned = to_do.back().size();
    // A loop that time ends has a path of any length: one of both ways finds it at once.
    start_path(std::move(to_do.back()), count % 2 == 0);
    to_do.pop_back();
    std::vector<Index> members = run();
    const std::vector<StepOutcome>& outcomes = recorder.outcomes;
    if (outcomes.size() < planned) stop(kMemoryOutside);
    paths.push_back({outcomes, std::move(members)});
    for (std::size_t other = planned; other < outcomes.size(); ++other) {
      to_do.emplace_back(outcomes.begin(), outcomes.begin() + static_cast<std::ptrdiff_t>(other) + 1);
      to_do.back().back().holds = !outcomes[other].holds;
    }
  }
  return paths;
}

Index record_argument(NumberKind kind, const std::string& name) {
  return index_of({.op = Operator::argument, .kind = kind, .name = name});
}

Index record_constant(NumberKind kind, double value) {
  if (std::signbit(value)) return record(Operator::negate, kind, record_constant(kind, -value));
  return index_of({.op = Operator::constant, .kind = kind, .value = value});
}

Index record(Operator op, NumberKind kind, Index a, Index b) {
  return index_of({.op = op, .kind = kind, .operands = {a, b, kNoIndex}});
}

Index record_call(const char* name, NumberKind kind, Index a, Index b, Index c) {
  return index_of({.op = Operator::call, .kind = kind, .operands = {a, b, c}, .name = name});
}

bool decide(Relation relation, Index left, Index right) {
  if (relation == Relation::equal && right < left) std::swap(left, right);
  if (const std::optional<bool> outcome = known(relation, left, right)) return *outcome;
  const StepComparison asked{left, right, relation};
  const StepIndex comparison = recorder.comparisons.number_of(asked);
  if (const std::optional<bool> outcome = implied(relation, left, right)) return *outcome;
  // Each of them has another path that goes the other way.
  if (recorder.outcomes.size() >= kStepPathsMax) stop(kTooManyPaths);
  const std::size_t place = recorder.outcomes.size();
  const bool is_planned = place < recorder.planned.size();
  if (is_planned && recorder.planned[place].comparison != comparison) stop(kMemoryOutside);
  const bool holds = is_planned ? recorder.planned[place].holds : recorder.others_hold;
  recorder.outcomes.push_back({comparison, holds});
  recorder.known.emplace(asked, holds);
  return holds;
}

void set_stop_handler(StopHandler handler) { stop_handler = handler; }

void stop(const char* why_incomplete) {
  if (stop_handler != nullptr) stop_handler(why_incomplete);
  std::abort();
}

}  // namespace hyrax::trace

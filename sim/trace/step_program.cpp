#include "sim/trace/step_program.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace hyrax {
namespace {

// Paths that share nothing repeat operations: no step that is one has so many.
constexpr std::size_t kInstructionsMax = 1 << 20;

// Of an argument or a member: below kStepMembersMax a member, else an argument; kNoIndex: of another
// function.
StepIndex source_of(std::string_view name, CoreFunction function, std::size_t members) {
  for (StepIndex member = 0; member < members && function != CoreFunction::construct; ++member)
    if (name == member_name(member)) return member;
  const auto& names = kArgumentNames[static_cast<std::size_t>(function)];
  const auto place = std::ranges::find(names, name);
  if (place == names.end()) return kNoIndex;
  return static_cast<StepIndex>(kStepMembersMax) + static_cast<StepIndex>(place - names.begin());
}

void execute(std::span<const StepInstruction> instructions, double* values) {
  for (const StepInstruction& instruction : instructions) {
    const double a = values[instruction.operands[0]];
    const double b = values[instruction.operands[1]];
    double& result = values[instruction.result];
    switch (instruction.op) {
      case Operator::add:
        result = a + b;
        break;
      case Operator::multiply:
        result = a * b;
        break;
      case Operator::divide:
        result = a / b;
        break;
      case Operator::negate:
        result = -a;
        break;
      default:
        result = instruction.function(a, b, values[instruction.operands[2]]);
    }
  }
}

StepInstruction instruction_of(const TracedStep& step, StepIndex index) {
  const Expression& expression = step.expressions[index];
  StepInstruction instruction{.function = operation_of(expression), .op = expression.op, .result = index};
  std::ranges::copy(expression.used_operands(), instruction.operands.begin());
  // What is done in place is done in double.
  if (expression.kind != NumberKind::real && instruction.function != nullptr) instruction.op = Operator::call;
  return instruction;
}

bool is_leaf(const Expression& expression) {
  return expression.op == Operator::argument || expression.op == Operator::constant;
}

// 2^31 is the least int.
double value_of(const Expression& constant) {
  const bool wraps = constant.kind == NumberKind::whole && constant.value == 0x1p31;
  return wraps ? -constant.value : constant.value;
}

// The values of one call, on the stack where they fit.
class Values {
 public:
  explicit Values(std::size_t count) {
    if (count > near_.size()) far_.resize(count);
  }
  double* data() { return far_.empty() ? near_.data() : far_.data(); }

 private:
  std::array<double, 256> near_;  // NOLINT: written before it is read.
  std::vector<double> far_;
};

}  // namespace

std::shared_ptr<const StepProgram> make_step_program(const TracedStep& step) {
  if (step.members.size() < 4 || step.members.size() > kStepMembersMax || step.describes_itself())
    return nullptr;
  StepProgram program(step);
  for (const Expression& expression : step.expressions)
    if (is_leaf(expression))  // They come first.
      program.leaves_.push_back(expression.op == Operator::constant ? value_of(expression) : 0.0);
  for (std::size_t function = 0; function < kCoreFunctions; ++function)
    if (!program.add_function(static_cast<CoreFunction>(function))) return nullptr;
  for (StepIndex index = 0; index < step.expressions.size(); ++index)
    if (!is_leaf(step.expressions[index])) program.all_.push_back(instruction_of(step, index));
  program.contacts_ = find_path_contacts(step);
  for (const std::vector<PathContact>& met : program.contacts_)
    for (const PathContact& contact : met) program.walls_ |= static_cast<std::uint8_t>(contact.wall);
  return std::make_shared<const StepProgram>(std::move(program));
}

bool StepProgram::add_function(CoreFunction function) {
  const std::vector<StepPath>& paths = step_.paths_of(function);
  const auto tree = make_decision_tree(paths);
  if (!tree) return false;
  Function& program = functions_[static_cast<std::size_t>(function)];
  std::vector<bool> is_known(step_.expressions.size());
  for (StepIndex index = 0; index < step_.expressions.size(); ++index) {
    const Expression& leaf = step_.expressions[index];
    if (leaf.op == Operator::constant) is_known[index] = true;
    if (leaf.op != Operator::argument) continue;
    const StepIndex source = source_of(leaf.name, function, step_.members.size());
    is_known[index] = source != kNoIndex;
    if (is_known[index]) program.loads.push_back({index, source});
  }
  // Depth first: what is known at a node is what was calculated on the way to it.
  struct Visit {
    StepIndex node = 0;
    bool is_done = false;
    std::vector<StepIndex> added = {};
  };
  program.nodes.resize(tree->size());
  std::vector<Visit> visits = {{}};
  while (!visits.empty()) {
    Visit& visit = visits.back();
    if (visit.is_done) {
      for (const StepIndex expression : visit.added) is_known[expression] = false;
      visits.pop_back();
      continue;
    }
    visit.is_done = true;
    const DecisionNode decision = (*tree)[visit.node];
    const bool is_end = decision.comparison == kNoIndex;
    Node& node = program.nodes[visit.node];
    node.begin = program.instructions.size();
    node.decision = decision;
    if (!is_end) node.comparison = step_.comparisons[decision.comparison];
    std::vector<StepIndex> wanted = {node.comparison.left, node.comparison.right};
    if (is_end) wanted = paths[decision.path].members;
    const bool is_emitted = emit(std::move(wanted), is_known, visit.added, program);
    node.end = program.instructions.size();
    if (!is_emitted || node.end > kInstructionsMax) return false;
    if (is_end) continue;
    visits.push_back({decision.if_false});
    visits.push_back({decision.if_false + 1});
  }
  return true;
}

bool StepProgram::emit(std::vector<StepIndex> open, std::vector<bool>& is_known,
                       std::vector<StepIndex>& added, Function& program) const {
  while (!open.empty()) {
    const StepIndex now = open.back();
    if (is_known[now]) {
      open.pop_back();
      continue;
    }
    const Expression& operation = step_.expressions[now];
    if (is_leaf(operation)) return false;  // An argument of another function.
    const std::size_t open_before = open.size();
    for (const StepIndex operand : operation.used_operands())
      if (!is_known[operand]) open.push_back(operand);
    if (open.size() > open_before) continue;
    program.instructions.push_back(instruction_of(step_, now));
    if (program.instructions.back().function == nullptr) return false;
    is_known[now] = true;
    added.push_back(now);
    open.pop_back();
  }
  return true;
}

void StepProgram::load(const Function& program, std::span<const double> members,
                       const StepArguments& arguments, double* values) const {
  std::memcpy(values, leaves_.data(), leaves_.size() * sizeof(double));
  for (const auto& [result, source] : program.loads)
    values[result] = source < kStepMembersMax ? members[source] : arguments[source - kStepMembersMax];
}

StepIndex StepProgram::run(CoreFunction function, std::span<double> members,
                           const StepArguments& arguments) const {
  const Function& program = functions_[static_cast<std::size_t>(function)];
  Values scratch(step_.expressions.size());
  double* const values = scratch.data();
  load(program, members, arguments, values);
  StepIndex now = 0;
  while (true) {
    const Node& node = program.nodes[now];
    execute(std::span(program.instructions).subspan(node.begin, node.end - node.begin), values);
    if (node.decision.comparison == kNoIndex) {
      const std::vector<StepIndex>& ends = step_.paths_of(function)[node.decision.path].members;
      for (std::size_t member = 0; member < ends.size(); ++member) members[member] = values[ends[member]];
      return node.decision.path;
    }
    const auto& [left, right, relation] = node.comparison;
    now = node.decision.if_false + (holds(relation, values[left], values[right]) ? 1 : 0);
  }
}

void StepProgram::evaluate(std::span<const double> members, const StepArguments& arguments,
                           std::vector<double>& values) const {
  values.resize(step_.expressions.size());
  load(functions_[static_cast<std::size_t>(CoreFunction::update)], members, arguments, values.data());
  execute(all_, values.data());
}

}  // namespace hyrax

#include "sim/trace/step_program.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace hyrax {
namespace {

// Paths that share nothing repeat operations: no step that is one has so many.
constexpr std::size_t kInstructionsMax = 1 << 20;

// Index of a member by its name; -1: none.
std::int32_t member_of(std::string_view name, std::size_t members) {
  for (std::size_t member = 0; member < members; ++member)
    if (name == member_name(member)) return static_cast<std::int32_t>(member);
  return -1;
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

StepInstruction instruction_of(const TracedStep& step, std::int32_t index) {
  const Expression& expression = step.expressions[static_cast<std::size_t>(index)];
  StepInstruction instruction{.function = operation_of(expression), .op = expression.op, .result = index};
  for (std::size_t place = 0; place < expression.operands.size(); ++place)
    instruction.operands[place] = std::max(expression.operands[place], 0);
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
  if (step.members.size() < 4 || step.members.size() > kStepMembersMax) return nullptr;
  StepProgram program(step);
  for (const Expression& expression : step.expressions)
    if (is_leaf(expression))  // They come first.
      program.leaves_.push_back(expression.op == Operator::constant ? value_of(expression) : 0.0);
  for (std::size_t function = 0; function < kCoreFunctions; ++function)
    if (!program.add_function(static_cast<CoreFunction>(function))) return nullptr;
  for (std::size_t index = 0; index < step.expressions.size(); ++index)
    if (!is_leaf(step.expressions[index]))
      program.all_.push_back(instruction_of(step, static_cast<std::int32_t>(index)));
  program.contacts_ = find_path_contacts(step);
  for (const std::vector<PathContact>& contacts : program.contacts_) {
    std::uint8_t bits = 0;
    for (const PathContact& contact : contacts) bits |= static_cast<std::uint8_t>(contact.wall);
    program.contact_bits_.push_back(bits);
  }
  return std::make_shared<const StepProgram>(std::move(program));
}

bool StepProgram::add_function(CoreFunction function) {
  const std::vector<StepPath>& paths = step_.paths_of(function);
  const auto tree = make_decision_tree(paths);
  if (!tree) return false;
  Function& program = functions_[static_cast<std::size_t>(function)];
  const auto& names = kArgumentNames[static_cast<std::size_t>(function)];
  for (std::size_t index = 0; index < step_.expressions.size(); ++index) {
    const Expression& leaf = step_.expressions[index];
    if (leaf.op != Operator::argument) continue;
    const auto name = std::find(names.begin(), names.end(), leaf.name);
    const std::int32_t member =
        function == CoreFunction::construct ? -1 : member_of(leaf.name, step_.members.size());
    if (member >= 0)
      program.loads.push_back({static_cast<std::int32_t>(index), member});
    else if (name != names.end())
      program.loads.push_back(
          {static_cast<std::int32_t>(index),
           static_cast<std::int32_t>(kStepMembersMax) + static_cast<std::int32_t>(name - names.begin())});
  }
  // Depth first: what is known at a node is what was calculated on the way to it.
  std::vector<bool> is_known(step_.expressions.size());
  for (std::size_t index = 0; index < step_.expressions.size(); ++index)
    is_known[index] = step_.expressions[index].op == Operator::constant;
  for (const Load& load : program.loads) is_known[static_cast<std::size_t>(load.result)] = true;
  struct Visit {
    std::int32_t node = 0;
    bool is_done = false;
    std::vector<std::int32_t> added = {};
  };
  program.nodes.resize(tree->size());
  std::vector<Visit> visits = {{}};
  while (!visits.empty()) {
    Visit& visit = visits.back();
    if (visit.is_done) {
      for (const std::int32_t expression : visit.added)
        is_known[static_cast<std::size_t>(expression)] = false;
      visits.pop_back();
      continue;
    }
    visit.is_done = true;
    Node& node = program.nodes[static_cast<std::size_t>(visit.node)];
    node.decision = (*tree)[static_cast<std::size_t>(visit.node)];
    node.begin = program.instructions.size();
    bool is_emitted = true;
    if (node.decision.comparison >= 0) {
      node.comparison = step_.comparisons[static_cast<std::size_t>(node.decision.comparison)];
      is_emitted = emit(node.comparison.left, is_known, visit.added, program) &&
                   emit(node.comparison.right, is_known, visit.added, program);
    } else {
      for (const std::int32_t member : paths[static_cast<std::size_t>(node.decision.path)].members)
        is_emitted = is_emitted && emit(member, is_known, visit.added, program);
    }
    node.end = program.instructions.size();
    if (!is_emitted || node.end > kInstructionsMax) return false;
    if (node.decision.comparison < 0) continue;
    const DecisionNode decision = node.decision;
    visits.push_back({decision.if_false});
    visits.push_back({decision.if_true});
  }
  return true;
}

// The operations that an expression needs and that are not done yet, operands first.
bool StepProgram::emit(std::int32_t expression, std::vector<bool>& is_known, std::vector<std::int32_t>& added,
                       Function& program) const {
  std::vector<std::int32_t> open = {expression};
  while (!open.empty()) {
    const std::int32_t now = open.back();
    if (is_known[static_cast<std::size_t>(now)]) {
      open.pop_back();
      continue;
    }
    const Expression& operation = step_.expressions[static_cast<std::size_t>(now)];
    if (is_leaf(operation)) return false;  // An argument of another function.
    bool is_ready = true;
    for (const std::int32_t operand : operation.operands)
      if (operand >= 0 && !is_known[static_cast<std::size_t>(operand)]) {
        open.push_back(operand);
        is_ready = false;
      }
    if (!is_ready) continue;
    program.instructions.push_back(instruction_of(step_, now));
    if (program.instructions.back().function == nullptr) return false;
    is_known[static_cast<std::size_t>(now)] = true;
    added.push_back(now);
    open.pop_back();
  }
  return true;
}

void StepProgram::load(const Function& program, std::span<const double> members,
                       const StepArguments& arguments, double* values) const {
  std::memcpy(values, leaves_.data(), leaves_.size() * sizeof(double));
  for (const Load& load : program.loads) {
    const auto source = static_cast<std::size_t>(load.source);
    values[load.result] = source < kStepMembersMax ? members[source] : arguments[source - kStepMembersMax];
  }
}

std::int32_t StepProgram::run(CoreFunction function, std::span<double> members,
                              const StepArguments& arguments) const {
  const Function& program = functions_[static_cast<std::size_t>(function)];
  Values scratch(step_.expressions.size());
  double* const values = scratch.data();
  load(program, members, arguments, values);
  std::size_t now = 0;
  while (true) {
    const Node& node = program.nodes[now];
    execute(std::span(program.instructions).subspan(node.begin, node.end - node.begin), values);
    if (node.decision.comparison < 0) {
      const StepPath& path = step_.paths_of(function)[static_cast<std::size_t>(node.decision.path)];
      for (std::size_t member = 0; member < path.members.size(); ++member)
        members[member] = values[path.members[member]];
      return node.decision.path;
    }
    now = static_cast<std::size_t>(
        holds(node.comparison.relation, values[node.comparison.left], values[node.comparison.right])
            ? node.decision.if_true
            : node.decision.if_false);
  }
}

void StepProgram::evaluate(std::span<const double> members, const StepArguments& arguments,
                           std::vector<double>& values) const {
  values.resize(step_.expressions.size());
  load(functions_[static_cast<std::size_t>(CoreFunction::update)], members, arguments, values.data());
  execute(all_, values.data());
}

}  // namespace hyrax

#include "sim/described/described_step.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "sim/described/scripted_body.h"
#include "sim/motion/state.h"
#include "sim/scenario/split_mix64.h"
#include "sim/trace/decision_tree.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

// As members of a step.
constexpr SettableList kLists[] = {SettableList::parameters, SettableList::inputs, SettableList::state};

// Calls the functions of a core and of its step, which is interpreted: values of every kind are doubles.
class StepCheck {
 public:
  StepCheck(const DescribedCore& core, const TracedStep& step)
      : core_(core), step_(step), values_(step.expressions.size()) {
    for (const SettableList list : kLists)
      for (const ValueInfo& value : list_of(core.description, list).values) infos_.push_back(value);
    for (const std::vector<StepPath>& paths : step.paths) trees_.push_back(make_decision_tree(paths).value());
  }

  // What differs; empty: nothing.
  std::string fault() {
    if (step_.member_names.size() != infos_.size() + core_.description.contacts.size() ||
        step_.paths.size() != 1 + core_.description.actions.size())
      return "other names";
    constexpr std::size_t kChecked = 100'000, kCheckedOperations = 50'000'000;
    std::size_t left = std::min(kChecked, kCheckedOperations / step_.expressions.size());
    while (left > 0) {
      start();
      for (std::size_t calls = 1 + below(20); calls > 0 && left > 0; --calls, --left) {
        const std::size_t function = below(4) == 0 ? below(step_.paths.size()) : 0;
        if (const std::string name = differing(function); !name.empty())
          return step_.function_names[function] + " makes another " + name;
      }
    }
    return {};
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(split_mix64(20261129, draws_++) % count);
  }

  // Within its limits: anywhere, a default, or a constant of the step.
  Word draw(const ValueInfo& info) {
    const bool is_whole = !is_floating(info.type);
    double low = -1000.0, high = 1000.0;
    if (info.type == ValueType::boolean || !info.names.empty())
      low = 0.0, high = info.names.empty() ? 1.0 : static_cast<double>(info.names.size() - 1);
    if (info.limits)
      low = number_of(info.type, (*info.limits)[0]), high = number_of(info.type, (*info.limits)[1]);
    const bool has_limits = low != -1000.0 || high != 1000.0;
    double number = low + (high - low + (is_whole ? 1.0 : 0.0)) * split_mix64_unit(20261129, draws_++);
    const Expression& any = step_.expressions[below(step_.expressions.size())];
    if (below(4) == 0) number = number_of(info.type, info.initial);
    if (any.op == Operator::constant && std::fabs(any.value) < 1e9)
      number = below(2) == 0 ? any.value : -any.value;
    if (has_limits) number = std::clamp(number, low, high);
    if (is_whole) return static_cast<Word>(static_cast<std::int64_t>(std::floor(number)));
    return info.type == ValueType::float32 ? word_of(static_cast<float>(number)) : word_of(number);
  }

  // A new core, all of whose values are drawn.
  void start() {
    body_ = core_.make();
    for (const SettableList list : kLists) {
      std::vector<std::optional<Word>> words;
      for (const ValueInfo& info : list_of(core_.description, list).values) words.emplace_back(draw(info));
      body_->set(list, words);
    }
  }

  // The compiled core's values, and contacts after a step.
  std::vector<double> members(bool has_contacts) {
    std::vector<double> numbers;
    for (const SettableList list : kLists) {
      std::vector<Word> words(list_of(core_.description, list).values.size());
      body_->read(list, words);
      for (const Word word : words) numbers.push_back(number_of(infos_[numbers.size()].type, word));
    }
    std::vector<std::uint8_t> flags(core_.description.contacts.size());
    if (has_contacts) body_->contacts(flags);
    numbers.insert(numbers.end(), flags.begin(), flags.end());
    return numbers;
  }

  void give(std::string_view argument, double value) {
    for (std::size_t index = 0; index < values_.size(); ++index)
      if (step_.expressions[index].op == Operator::argument && step_.expressions[index].name == argument)
        values_[index] = value;
  }

  // What the function of the step makes of every member.
  std::vector<double> interpret(std::size_t function) {
    const auto value = [&](StepIndex index) { return index == kNoIndex ? 0.0 : values_[index]; };
    for (std::size_t index = 0; index < values_.size(); ++index) {
      const Expression& expression = step_.expressions[index];
      const auto& [a, b, c] = expression.operands;
      if (expression.op == Operator::constant)  // 2^31 is the least int.
        values_[index] =
            expression.kind == NumberKind::whole && expression.value == 0x1p31 ? -0x1p31 : expression.value;
      else if (const OperationFunction operation = operation_of(expression))
        values_[index] = operation(value(a), value(b), value(c));
      else if (expression.op == Operator::call)  // Of a function that is not known.
        values_[index] = std::numeric_limits<double>::quiet_NaN();
    }
    const std::vector<DecisionNode>& tree = trees_[function];
    StepIndex now = 0;
    while (tree[now].comparison != kNoIndex) {
      const auto& [left, right, relation] = step_.comparisons[tree[now].comparison];
      now = tree[now].if_false + (holds(relation, values_[left], values_[right]) ? 1 : 0);
    }
    std::vector<double> ends;
    for (const StepIndex member : step_.paths[function][tree[now].path].members)
      ends.push_back(values_[member]);
    return ends;
  }

  // Calls both; the name of the first member that differs. Empty: none.
  std::string differing(std::size_t function) {
    const std::vector<double> before = members(false);
    for (std::size_t index = 0; index < infos_.size(); ++index) give(infos_[index].name, before[index]);
    if (function == 0) {
      constexpr double kDt_s[] = {1.0 / 60, 1.0 / 144, 0.0, 0.5};
      const double dt_s = kDt_s[below(4)] * (below(2) == 0 ? 1.0 : split_mix64_unit(20261129, draws_++));
      give("dt", dt_s);
      body_->step(dt_s);
    } else {
      const ActionInfo& action = core_.description.actions[function - 1];
      std::vector<Word> arguments;
      for (const ValueInfo& info : action.arguments) {
        arguments.push_back(draw(info));
        give(action.name + "(" + info.name + ")", number_of(info.type, arguments.back()));
      }
      body_->act(function - 1, arguments);
    }
    const std::vector<double> compiled = members(function == 0), traced = interpret(function);
    for (std::size_t index = 0; index < compiled.size(); ++index)
      if (!same_bits(compiled[index], traced[index]) &&
          !(std::isnan(compiled[index]) && std::isnan(traced[index])))
        return step_.member_names[index];
    return {};
  }

  const DescribedCore& core_;
  const TracedStep& step_;
  std::vector<double> values_;         // By expression of the step.
  std::vector<ValueInfo> infos_ = {};  // Of its members without contacts.
  std::vector<std::vector<DecisionNode>> trees_ = {};
  std::unique_ptr<DescribedBody> body_ = {};
  std::uint64_t draws_ = 0;
};

}  // namespace

DescribedStep described_step(const DescribedCore& core) {
  DescribedStep result{read_step(core.record.step), std::string(core.record.why_incomplete)};
  if (!result.step && result.why_incomplete.empty()) result.why_incomplete = "its text cannot be read";
  if (!result.step) return result;
  std::string fault;
  try {
    fault = StepCheck(core, *result.step).fault();
  } catch (const std::exception& error) {
    fault = error.what();
  }
  if (fault.empty()) return result;
  return {.why_incomplete = "the traced step does not give the compiled core's bits: " + fault};
}

}  // namespace hyrax

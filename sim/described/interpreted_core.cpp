#include "sim/described/interpreted_core.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "sim/described/scripted_body.h"
#include "sim/trace/decision_tree.h"
#include "sim/trace/step_program.h"

namespace hyrax {
namespace {

struct CoreStep {
  Description description;
  TracedStep step;
};

// A body that goes on by an interpreted step: values of every kind are doubles.
class InterpretedBody final : public DescribedBody {
 public:
  explicit InterpretedBody(std::shared_ptr<const CoreStep> core)
      : core_(std::move(core)), step_(core_->step), values_(step_.expressions.size()) {
    for (const SettableList list : kStepLists)
      for (const ValueInfo& value : infos_of(list)) members_.push_back(number_of(value.type, value.initial));
    members_.resize(step_.member_names.size());
    for (const std::vector<StepPath>& paths : step_.paths)
      trees_.push_back(make_decision_tree(paths).value());
    for (std::size_t index = 0; index < values_.size(); ++index)
      if (step_.expressions[index].op == Operator::argument) arguments_.push_back(index);
  }

  [[nodiscard]] std::unique_ptr<DescribedBody> copy() const override {
    auto body = std::make_unique<InterpretedBody>(core_);
    body->members_ = members_;
    return body;
  }
  void step(double dt_s) override {
    give("dt", dt_s);
    call(0);
  }
  void act(std::size_t action, std::span<const Word> words) override {
    const ActionInfo& info = core_->description.actions[action];
    for (std::size_t place = 0; place < words.size(); ++place)
      give(info.name + "(" + info.arguments[place].name + ")",
           number_of(info.arguments[place].type, words[place]));
    call(1 + action);
  }
  void play(const std::function<void()>& /*after_step*/, MadeRows& rows) override {
    for (const double dt_s : rows.dt_s) {
      step(dt_s);
      add_row(true, rows);
    }
  }
  void add_row(bool has_contacts, MadeRows& rows) override {
    const auto row_of = [&](auto& list, std::size_t width) {
      return std::span(list).subspan(rows.count * width, width);
    };
    const auto words = row_of(rows.words, 1 + infos_of(SettableList::state).size());
    words.front() = word_of(rows.dt_s[rows.count]);
    read(SettableList::state, words.subspan(1));
    for (std::size_t place = 1; place < words.size(); ++place)
      rows.all_are_finite &=
          !is_floating(infos_of(SettableList::state)[place - 1].type) || is_finite(words[place]);
    const auto flags = row_of(rows.contacts, core_->description.contacts.size());
    std::ranges::fill(flags, std::uint8_t{0});
    if (has_contacts) contacts(flags);
    ++rows.count;
  }
  void read(SettableList list, std::span<Word> words) override {
    const double* member = first_of(list);
    for (std::size_t place = 0; place < words.size(); ++place, ++member)
      words[place] = is_floating(infos_of(list)[place].type) ? word_of(*member)
                                                             : word_of(static_cast<std::int64_t>(*member));
  }
  void set(SettableList list, std::span<const std::optional<Word>> words) override {
    double* member = first_of(list);
    for (std::size_t place = 0; place < words.size(); ++place, ++member)
      if (words[place]) *member = number_of(infos_of(list)[place].type, *words[place]);
  }
  [[nodiscard]] Description describe() const override { return core_->description; }
  void contacts(std::span<std::uint8_t> flags) const override {
    std::transform(members_.end() - std::ssize(flags), members_.end(), flags.begin(),
                   [](double member) { return member != 0.0 ? 1 : 0; });
  }

 private:
  [[nodiscard]] const std::vector<ValueInfo>& infos_of(SettableList list) const {
    return list_of(core_->description, list).values;
  }
  [[nodiscard]] double* first_of(SettableList list) {
    double* member = members_.data();
    for (const SettableList* each = kStepLists; *each != list; ++each) member += infos_of(*each).size();
    return member;
  }

  void give(std::string_view argument, double value) {
    for (const std::size_t index : arguments_)
      if (step_.expressions[index].name == argument) values_[index] = value;
  }

  void call(std::size_t function) {
    auto member = members_.begin();
    for (const SettableList list : kStepLists)
      for (const ValueInfo& info : infos_of(list)) give(info.name, *member++);
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
    std::ranges::transform(step_.paths[function][tree[now].path].members, members_.begin(), value);
  }

  std::shared_ptr<const CoreStep> core_;
  const TracedStep& step_;
  std::vector<double> values_;  // By expression of the step.
  std::vector<std::size_t> arguments_ = {};
  std::vector<std::vector<DecisionNode>> trees_ = {};
  std::vector<double> members_ = {};
};

}  // namespace

DescribedCore interpreted(const DescribedCore& core, TracedStep step) {
  const auto parts = std::make_shared<const CoreStep>(CoreStep{core.description, std::move(step)});
  DescribedCore other{.description = core.description};
  other.description.outputs = {};
  other.description.properties = {};
  other.make = [parts]() -> std::unique_ptr<DescribedBody> {
    return std::make_unique<InterpretedBody>(parts);
  };
  return other;
}

}  // namespace hyrax

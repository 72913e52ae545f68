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

struct CoreStep {
  Description description;
  TracedStep step;
};

// A body that goes on by an interpreted step: values of every kind are doubles.
class InterpretedBody final : public DescribedBody {
 public:
  explicit InterpretedBody(std::shared_ptr<const CoreStep> core)
      : core_(std::move(core)), step_(core_->step), values_(step_.expressions.size()) {
    for (const SettableList list : kLists)
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
    for (const SettableList* each = kLists; *each != list; ++each) member += infos_of(*each).size();
    return member;
  }

  void give(std::string_view argument, double value) {
    for (const std::size_t index : arguments_)
      if (step_.expressions[index].name == argument) values_[index] = value;
  }

  void call(std::size_t function) {
    auto member = members_.begin();
    for (const SettableList list : kLists)
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

// Calls the functions of a core and of its step.
class StepCheck {
 public:
  StepCheck(const DescribedCore& core, const TracedStep& step)
      : core_(core), step_(step), traced_(std::make_shared<CoreStep>(CoreStep{core.description, step})) {}

  // What differs; empty: nothing.
  std::string fault() {
    std::size_t members = core_.description.contacts.size();
    for (const SettableList list : kLists) members += list_of(core_.description, list).values.size();
    if (step_.member_names.size() != members || step_.paths.size() != 1 + core_.description.actions.size())
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
    if (is_whole) return word_of(static_cast<std::int64_t>(std::floor(number)));
    return info.type == ValueType::float32 ? word_of(static_cast<float>(number)) : word_of(number);
  }

  // A new core; all values are drawn.
  void start() {
    compiled_ = core_.make();
    for (const SettableList list : kLists) {
      std::vector<std::optional<Word>> words;
      for (const ValueInfo& info : list_of(core_.description, list).values) words.emplace_back(draw(info));
      compiled_->set(list, words);
      traced_.set(list, words);
    }
  }

  // Calls both; the name of the first member that differs. Empty: none.
  std::string differing(std::size_t function) {
    std::vector<Word> arguments;
    constexpr double kDt_s[] = {1.0 / 60, 1.0 / 144, 0.0, 0.5};
    double dt_s = 0.0;
    if (function == 0)
      dt_s = kDt_s[below(4)] * (below(2) == 0 ? 1.0 : split_mix64_unit(20261129, draws_++));
    else
      for (const ValueInfo& info : core_.description.actions[function - 1].arguments)
        arguments.push_back(draw(info));
    for (DescribedBody* const body : {compiled_.get(), static_cast<DescribedBody*>(&traced_)})
      if (function == 0)
        body->step(dt_s);
      else
        body->act(function - 1, arguments);
    const std::vector<Word> compiled = members(*compiled_, function == 0);
    const std::vector<Word> traced = members(traced_, function == 0);
    const auto place = std::mismatch(compiled.begin(), compiled.end(), traced.begin()).first;
    return place == compiled.end() ? ""
                                   : step_.member_names[static_cast<std::size_t>(place - compiled.begin())];
  }

  // Its values, and contacts after a step.
  [[nodiscard]] std::vector<Word> members(DescribedBody& body, bool has_contacts) const {
    std::vector<Word> all;
    for (const SettableList list : kLists) {
      std::vector<Word> words(list_of(core_.description, list).values.size());
      body.read(list, words);
      all.insert(all.end(), words.begin(), words.end());
    }
    std::vector<std::uint8_t> flags(has_contacts ? core_.description.contacts.size() : 0);
    if (has_contacts) body.contacts(flags);
    all.insert(all.end(), flags.begin(), flags.end());
    return all;
  }

  const DescribedCore& core_;
  const TracedStep& step_;
  InterpretedBody traced_;
  std::unique_ptr<DescribedBody> compiled_ = {};
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

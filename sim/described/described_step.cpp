#include "sim/described/described_step.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "sim/described/interpreted_core.h"
#include "sim/described/scripted_body.h"
#include "sim/scenario/split_mix64.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

// Calls the functions of a core and of its step.
class StepCheck {
 public:
  StepCheck(const DescribedCore& core, const TracedStep& step)
      : core_(core), step_(step), traced_(interpreted(core, step).make()) {}

  // What differs; empty: nothing.
  std::string fault() {
    std::size_t members = core_.description.contacts.size();
    for (const SettableList list : kStepLists) members += list_of(core_.description, list).values.size();
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
    for (const SettableList list : kStepLists) {
      std::vector<std::optional<Word>> words;
      for (const ValueInfo& info : list_of(core_.description, list).values) words.emplace_back(draw(info));
      compiled_->set(list, words);
      traced_->set(list, words);
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
    for (DescribedBody* const body : {compiled_.get(), traced_.get()})
      if (function == 0)
        body->step(dt_s);
      else
        body->act(function - 1, arguments);
    const std::vector<Word> compiled = members(*compiled_, function == 0);
    const std::vector<Word> traced = members(*traced_, function == 0);
    const auto place = std::mismatch(compiled.begin(), compiled.end(), traced.begin()).first;
    return place == compiled.end() ? ""
                                   : step_.member_names[static_cast<std::size_t>(place - compiled.begin())];
  }

  // Its values, and contacts after a step.
  [[nodiscard]] std::vector<Word> members(DescribedBody& body, bool has_contacts) const {
    std::vector<Word> all;
    for (const SettableList list : kStepLists) {
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
  std::unique_ptr<DescribedBody> traced_;
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

}  // namespace hyrax

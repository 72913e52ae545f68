#include "tools/described/random_scenario.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/split_mix64.h"
#include "sim/search/draws.h"
#include "tools/described/value_json.h"

namespace hyrax {
namespace {

constexpr std::int64_t kRandomStepsMax = 600;
constexpr std::uint64_t kAddedEventsMax = 4;
constexpr double kRates_hz[] = {24.0, 30.0, 50.0, 60.0, 75.0, 90.0, 120.0, 144.0, 240.0, 1000.0};

class Variation {
 public:
  Variation(const Description& description, std::uint64_t seed, std::uint64_t attempt)
      : description_(description), draws_(seed), attempt_(attempt) {}

  DescribedScenario of(DescribedScenario scenario) {
    steps_ = std::min(step_count(scenario), kRandomStepsMax);
    vary_clock(scenario);
    vary_list(description_.parameters, scenario.parameters);
    vary_list(description_.inputs, scenario.inputs);
    vary_list(description_.state, scenario.start);
    for (InputArray& array : scenario.input_arrays) {
      array.words.resize(static_cast<std::size_t>(steps_));
      if (attempt_ == kLastAttempt) continue;
      std::erase_if(scenario.inputs, [&](const GivenValue& given) { return given.first == array.input; });
      for (Word& word : array.words) word = draw(description_.inputs.values[array.input], word);
    }
    vary_events(scenario);
    scenario.expect.reset();
    scenario.record_every = 1;
    return scenario;
  }

 private:
  void vary_clock(DescribedScenario& scenario) {
    if (auto* const trace = std::get_if<RecordedSteps>(&scenario.clock.base)) {
      trace->dt_s.resize(static_cast<std::size_t>(steps_));
      if (steps_ > 0) return;
    }
    scenario.clock = {FixedRate{draws_.one_of(kRates_hz)}, {}};
    if (draws_.once_in(2)) {
      const auto kind = static_cast<Jitter::Kind>(draws_.below(3));
      const double amount = kind == Jitter::Kind::normal ? 0.002 : draws_.between(0.0, 1.0);
      scenario.clock.jitter = Jitter{kind, amount, draws_.bits()};
    }
    scenario.length = steps_;
  }

  // Half of the values that could be given, and half as many in each further attempt.
  void vary_list(const ValueList& list, std::vector<GivenValue>& given) {
    std::vector<GivenValue> drawn;
    for (std::size_t place = 0; place < list.values.size(); ++place) {
      const auto old = std::ranges::find(given, place, &GivenValue::first);
      const bool is_given = old != given.end();
      const Word word = is_given ? old->second : list.values[place].initial;
      if (attempt_ < kLastAttempt && draws_.once_in(std::uint64_t{2} << attempt_))
        drawn.emplace_back(place, draw(list.values[place], word));
      else if (is_given)
        drawn.emplace_back(place, word);
    }
    given = std::move(drawn);
  }

  void vary_events(DescribedScenario& scenario) {
    if (steps_ == 0) return scenario.events.clear();
    for (DescribedEvent& event : scenario.events) vary_action(event.action);
    // Of holds the order is kept: one that is held is let go.
    std::vector<std::int64_t> frames = any_frames(scenario.events.size());
    for (std::size_t event = 0; event < frames.size(); ++event) scenario.events[event].when = frames[event];
    for (std::uint64_t added = draws_.below(kAddedEventsMax + 1); added > 0; --added) {
      const DescribedEvent event{any_frame(), any_action(scenario)};
      const auto is_before = [](const DescribedEvent& a, const DescribedEvent& b) {
        return std::get<std::int64_t>(a.when) < std::get<std::int64_t>(b.when);
      };
      scenario.events.insert(std::ranges::upper_bound(scenario.events, event, is_before), event);
    }
  }

  std::int64_t any_frame() {
    return static_cast<std::int64_t>(draws_.below(static_cast<std::uint64_t>(steps_)));
  }
  std::vector<std::int64_t> any_frames(std::size_t count) {
    std::vector<std::int64_t> frames;
    while (frames.size() < count) frames.push_back(any_frame());
    std::ranges::sort(frames);
    return frames;
  }

  void vary_action(DescribedAction& action) {
    if (auto* const set = std::get_if<SetValues>(&action)) {
      for (auto& [place, word] : set->inputs) word = draw(description_.inputs.values[place], word);
      for (auto& [place, word] : set->state) word = draw(description_.state.values[place], word);
    } else if (auto* const act = std::get_if<Act>(&action)) {
      for (std::size_t argument = 0; argument < act->arguments.size(); ++argument)
        act->arguments[argument] =
            draw(description_.actions[act->action].arguments[argument], act->arguments[argument]);
    } else if (auto* const hitch = std::get_if<Hitch>(&action)) {
      hitch->dt_s = draws_.between(0.0, 1.0);
    }
  }

  // An enum argument is never drawn: it is that of an event of the scenario. Without one it is a hitch.
  [[nodiscard]] DescribedAction any_act(std::size_t action, const DescribedScenario& scenario) const {
    const std::vector<ValueInfo>& arguments = description_.actions[action].arguments;
    if (std::ranges::none_of(arguments, &ValueInfo::is_enum))
      return Act{action, std::vector<Word>(arguments.size())};
    for (const DescribedEvent& event : scenario.events)
      if (const auto* const act = std::get_if<Act>(&event.action); act != nullptr && act->action == action)
        return *act;
    return Hitch{};
  }

  DescribedAction any_action(const DescribedScenario& scenario) {
    const std::uint64_t kind = draws_.below(description_.actions.size() + 2);
    DescribedAction action = Hitch{};
    if (kind < description_.actions.size()) {
      action = any_act(kind, scenario);
    } else if (kind == description_.actions.size() && !description_.inputs.values.empty()) {
      const std::size_t input = draws_.below(description_.inputs.values.size());
      const bool has_array =
          std::ranges::find(scenario.input_arrays, input, &InputArray::input) != scenario.input_arrays.end();
      SetValues set;
      if (!has_array) set.inputs = {{input, description_.inputs.values[input].initial}};
      action = set;
    }
    vary_action(action);
    return action;
  }

  Word draw(const ValueInfo& value, Word word) {
    if (value.type == ValueType::boolean) return draws_.below(2);
    const auto [low, high] = file_limits(value);
    if (value.limits || !value.names.empty()) return uniform(value.type, low, high);
    return value.is_enum ? word : scaled(value.type, number_of(value.type, word));
  }

  Word uniform(ValueType type, Word low, Word high) {
    if (is_floating(type)) return floating(type, draws_.between(number_of(type, low), number_of(type, high)));
    const std::uint64_t span = high - low;  // As unsigned integers it is right for signed ones, too.
    return low + (span + 1 == 0 ? draws_.bits() : draws_.below(span + 1));
  }

  Word scaled(ValueType type, double number) {
    const double fraction = draws_.between(1.0, 2.0);
    const double size = std::ldexp(fraction, static_cast<int>(draws_.below(6)) - 3);
    const double sign = draws_.once_in(2) ? -1.0 : 1.0;
    const double drawn = number == 0.0 ? draws_.between(-100.0, 100.0) : sign * size * number;
    if (is_floating(type)) return floating(type, drawn);
    const auto [low, high] = range_of(type);
    const double whole = std::trunc(drawn);
    if (whole <= number_of(type, low)) return low;
    if (whole >= number_of(type, high)) return high;
    return whole < 0.0 ? static_cast<Word>(static_cast<std::int64_t>(whole)) : static_cast<Word>(whole);
  }

  static Word floating(ValueType type, double number) {
    const auto [low, high] = range_of(type);
    const double value = std::clamp(number, number_of(type, low), number_of(type, high));
    return type == ValueType::float32 ? word_of(static_cast<float>(value)) : word_of(value);
  }

  const Description& description_;
  Draws draws_;
  std::uint64_t attempt_;
  std::int64_t steps_ = 0;
};

}  // namespace

DescribedScenario random_scenario(const Description& description,
                                  const std::vector<DescribedScenario>& library, std::uint64_t seed,
                                  std::uint64_t run, std::uint64_t attempt) {
  // Not the next numbers of the seed, which the next run would draw as well.
  const std::uint64_t of_run = split_mix64(seed, run);
  DescribedScenario scenario =
      Variation(description, attempt == 0 ? of_run : split_mix64(of_run, ~attempt), attempt)
          .of(library[run % library.size()]);
  scenario.name = "fuzz-" + std::to_string(seed) + "-" + std::to_string(run);
  scenario.core = description.core;
  scenario.schema.reset();
  scenario.description.reset();
  return scenario;
}

}  // namespace hyrax

// A scenario of a core that describes itself, as a plain value.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sim/described/description.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A value of a list by its place there, and what it is set to.
using GivenValue = std::pair<std::size_t, Word>;

/// An input that has a value for each frame.
struct InputArray {
  std::size_t input = 0;
  std::vector<Word> words = {};
  bool operator==(const InputArray&) const = default;
};

struct SetValues {
  std::vector<GivenValue> inputs = {};  ///< In declared order, as all lists of given values here.
  std::vector<GivenValue> state = {};
  bool operator==(const SetValues&) const = default;
};
struct Hold {
  bool operator==(const Hold&) const = default;
};
struct Go {
  bool operator==(const Go&) const = default;
};
/// An action of the core, with its arguments.
struct Act {
  std::size_t action = 0;
  std::vector<Word> arguments = {};
  bool operator==(const Act&) const = default;
};
using DescribedAction = std::variant<SetValues, Hitch, Hold, Go, Act>;
/// The keys of those that every core has, by their index; of the others that of the core's action.
inline constexpr std::array<std::string_view, std::variant_size_v<DescribedAction> - 1> kOwnEventNames = {
    "set", "hitch", "hold", "go"};

/// The key of an action in a scenario's event.
[[nodiscard]] inline std::string event_name(const Description& description, const DescribedAction& action) {
  const auto* const act = std::get_if<Act>(&action);
  return act != nullptr ? description.actions[act->action].name : std::string(kOwnEventNames[action.index()]);
}

struct DescribedEvent {
  std::variant<std::int64_t, double> when;  ///< Frame number, or a time in s.
  DescribedAction action;
  bool operator==(const DescribedEvent&) const = default;
};

/// What the author means to hold; each rule only where it is set.
struct DescribedExpect {
  std::optional<bool> finite = {};
  /// Of state values, in declared order; of an exact value both ends are that.
  std::vector<std::pair<std::size_t, std::array<Word, 2>>> final = {};
  std::vector<std::pair<std::size_t, Interval>> contacts = {};
  std::optional<Interval> at_rest_since_s = {};
  std::optional<std::string> state_hash = {};
  bool operator==(const DescribedExpect&) const = default;
};

/// Places are those of the description for which it was read.
struct DescribedScenario : ScenarioHead {
  std::optional<std::string> core = {};  ///< The key `core`.
  std::vector<GivenValue> parameters = {};
  std::vector<GivenValue> inputs = {};
  std::vector<InputArray> input_arrays = {};
  std::vector<GivenValue> start = {};  ///< Of the state.
  std::vector<DescribedEvent> events = {};
  std::optional<DescribedExpect> expect = {};
  bool operator==(const DescribedScenario&) const = default;
};

/// Whether two scenarios play the same run: without name, description, schema and expect they are the same.
[[nodiscard]] inline bool plays_the_same(DescribedScenario a, DescribedScenario b) {
  for (DescribedScenario* const scenario : {&a, &b}) {
    scenario->name.clear();
    scenario->description.reset();
    scenario->schema.reset();
    scenario->core.reset();
    scenario->expect.reset();
  }
  return a == b;
}

}  // namespace hyrax

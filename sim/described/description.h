// What a core that describes itself is made of, as plain values.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "sim/described/value.h"

namespace hyrax {

inline constexpr std::string_view kDescribedModel = "hyrax-core/1";

struct ActionInfo {
  std::string name = {};
  std::vector<ValueInfo> arguments = {};
  bool operator==(const ActionInfo&) const = default;
};

struct PropertyInfo {
  std::string name = {};
  bool is_always = true;  ///< Else `sometimes`.
  bool operator==(const PropertyInfo&) const = default;
};

/// A range among the values of a list: every call of the list finds it as long.
struct RangeInfo {
  std::string name = {};
  std::size_t length = 0;
  bool operator==(const RangeInfo&) const = default;
};

/// Values in declared order.
struct ValueList {
  std::vector<ValueInfo> values = {};
  std::vector<RangeInfo> ranges = {};
  bool operator==(const ValueList&) const = default;
};

struct Description {
  std::string core = {};  ///< Its name, as "pool".
  ValueList state = {};
  ValueList inputs = {};
  ValueList parameters = {};
  ValueList outputs = {};
  std::vector<ActionInfo> actions = {};
  std::vector<std::string> contacts = {};
  std::vector<PropertyInfo> properties = {};
  std::vector<std::string> undeclared = {};  ///< What the core says it cannot declare.
  bool operator==(const Description&) const = default;
};

/// Whether a value of the state is in px.
[[nodiscard]] inline bool has_px(const Description& description) {
  return std::ranges::any_of(description.state.values,
                             [](const ValueInfo& value) { return value.unit == "px"; });
}

/// Two values in px whose names differ in one word, x and y: a position. Indices in the state.
struct PositionPair {
  std::size_t x = 0;
  std::size_t y = 0;
  std::string name = {};  ///< What both have: "a" of a.x_px; empty of x_px.
};
[[nodiscard]] std::vector<PositionPair> position_pairs(const Description& description);

/// What is wrong with names, limits and defaults, a sentence each; none: it can be used.
[[nodiscard]] std::vector<std::string> faults_of(const Description& description);

/// What of the names, types and order differs, in one sentence, as "value b.spin_rad_per_s was added"; empty:
/// nothing. Defaults and limits are not compared.
[[nodiscard]] std::string description_difference(const Description& before, const Description& after);

}  // namespace hyrax

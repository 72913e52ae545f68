// What a core that describes itself is made of, and its values, as plain values.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/result/value_type.h"

namespace hyrax {

/// A value, widened: a floating type is a binary64 (any NaN 0x7ff8000000000000), a signed integer an int64,
/// an unsigned one or a bool a uint64; an enum is its underlying type. A row is hashed as these.
using Word = std::uint64_t;

/// The type of T as a value. REQUIRES: T is a double, float, bool, integer or enum.
template <class T>
[[nodiscard]] constexpr ValueType value_type() {
  if constexpr (std::is_enum_v<T>) {
    constexpr ValueType kType = value_type<std::underlying_type_t<T>>();
    return kType == ValueType::boolean ? ValueType::uint8 : kType;  // Its values have names, not truth.
  } else if constexpr (std::is_same_v<T, bool>) {
    return ValueType::boolean;
  } else if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) <= sizeof(double));
    return sizeof(T) == sizeof(double) ? ValueType::float64 : ValueType::float32;
  } else {
    constexpr int kLog2Size = std::countr_zero(sizeof(T));
    const ValueType first = std::is_signed_v<T> ? ValueType::int8 : ValueType::uint8;
    return static_cast<ValueType>(static_cast<int>(first) + kLog2Size);
  }
}

/// Whether the word of a floating type is.
[[nodiscard]] constexpr bool is_finite(Word word) {
  constexpr Word kInfinity = 0x7ff0000000000000;
  return (word & kInfinity) != kInfinity;
}

template <class T>
[[nodiscard]] constexpr Word word_of(T value) {
  if constexpr (std::is_enum_v<T>) {
    return word_of(static_cast<std::underlying_type_t<T>>(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    const Word bits = std::bit_cast<Word>(static_cast<double>(value));
    return is_finite(bits) || bits << 12 == 0 ? bits : Word{0x7ff8000000000000};
  } else if constexpr (std::is_signed_v<T>) {
    return static_cast<Word>(static_cast<std::int64_t>(value));
  } else {
    return static_cast<Word>(value);
  }
}
/// REQUIRES: a word of that type.
template <class T>
[[nodiscard]] constexpr T value_of(Word word) {
  if constexpr (std::is_enum_v<T>)
    return static_cast<T>(value_of<std::underlying_type_t<T>>(word));
  else if constexpr (std::is_floating_point_v<T>)
    return static_cast<T>(std::bit_cast<double>(word));
  else
    return static_cast<T>(word);
}

/// The word as the nearest double, for distances, limits and pictures.
[[nodiscard]] constexpr double number_of(ValueType type, Word word) {
  if (is_floating(type)) return std::bit_cast<double>(word);
  if (is_signed_integer(type)) return static_cast<double>(static_cast<std::int64_t>(word));
  return static_cast<double>(word);
}

/// The double that texts show: of a float32 the one whose shortest text is the float's, as 0.1.
[[nodiscard]] double shown_number_of(ValueType type, Word word);

/// Whether a < b, exactly. REQUIRES: words of that type.
[[nodiscard]] constexpr bool is_less(ValueType type, Word a, Word b) {
  if (is_floating(type)) return std::bit_cast<double>(a) < std::bit_cast<double>(b);
  if (is_signed_integer(type)) return static_cast<std::int64_t>(a) < static_cast<std::int64_t>(b);
  return a < b;
}

/// What a core says of a value.
struct ValueInfo {
  std::string name = {};  ///< "a.x_px".
  ValueType type = ValueType::float64;
  std::string unit = {};  ///< "px/s"; empty: none. unit_of(name).
  Word initial = 0;       ///< Of a default constructed core; 0 for outputs and arguments.
  std::optional<std::array<Word, 2>> limits = {};  ///< Inclusive.
  std::vector<std::string> names = {};             ///< Of the values 0, 1, ...
  bool is_enum = false;                            ///< Any number may be none of its values.
  bool operator==(const ValueInfo&) const = default;
};

/// The unit that a name ends in: of "a.vx_px_per_s", "px/s"; empty: none.
[[nodiscard]] std::string unit_of(std::string_view name);

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

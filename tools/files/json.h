// A JSON document as it was written: order of keys, repeated keys and the sign of zero are kept.
//
// Numbers are read correctly rounded and written shortest-round-trip in any locale. Only json.cpp includes
// the parser, nlohmann-json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hyrax {

/// A number of which a double keeps less than the text says: with a fraction that was lost in rounding, or
/// beyond the largest double (the value is then infinite).
struct RoundedNumber {
  double value;
  std::string text;
};

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(RoundedNumber value) : value_(std::move(value)) {}
  Json(int value) : value_(static_cast<std::int64_t>(value)) {}
  Json(std::int64_t value) : value_(value) {}
  Json(std::uint64_t value) : value_(value) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(Array value) : value_(std::move(value)) {}
  Json(Object value) : value_(std::move(value)) {}

  /// The value if it is of that type, else nullptr.
  template <class T>
  [[nodiscard]] const T* get() const {
    return std::get_if<T>(&value_);
  }
  template <class T>
  [[nodiscard]] T* get() {
    return std::get_if<T>(&value_);
  }
  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  [[nodiscard]] bool is_number() const {
    return get<double>() != nullptr || get<std::int64_t>() != nullptr || get<std::uint64_t>() != nullptr ||
           get<RoundedNumber>() != nullptr;
  }
  /// REQUIRES: is_number().
  [[nodiscard]] double number() const;

  /// Whether it is a number without fraction: 60.0 is, and 59.99999999999999999999 is not, which reads as 60.
  [[nodiscard]] bool is_whole() const;

  /// The first member of that key; nullptr if there is none or this is not an object.
  [[nodiscard]] const Json* find(std::string_view key) const;
  /// Its value if it is of that type, else nullptr.
  template <class T>
  [[nodiscard]] const T* get(std::string_view key) const {
    const Json* const member = find(key);
    return member == nullptr ? nullptr : member->get<T>();
  }

 private:
  // A non-negative integer up to 2^64 - 1 is unsigned, a negative one signed, every other number
  // (and -0) a double. Beyond 2^53 a whole one that fits is an integer though it has a point or an exponent.
  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, RoundedNumber, std::string, Array,
               Object>
      value_;
};

/// The deepest nesting that is read.
inline constexpr int kJsonNestingMax = 100;

/// The value; null if there is none.
template <class Value>
[[nodiscard]] Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// What `to_json` makes of each item.
template <class Items, class ToJson>
[[nodiscard]] Json::Array list_of(const Items& items, const ToJson& to_json) {
  Json::Array list;
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

/// Parses a document.
/// ERRORS: Failure(bad_input) "SOURCE: line L, column C: ..." for anything that is not one JSON
/// text in UTF-8 without byte-order mark, deeper nesting, or very many numbers beyond binary64.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& source);

/// The document as text, without a last newline. Members and elements down to a depth have lines of their
/// own, the rest is in one line. A non-finite number becomes the string "NaN", "Infinity" or "-Infinity".
[[nodiscard]] std::string to_text(const Json& json, int depth_indented = 0);

/// Shortest decimal text that reads back to the same double.
[[nodiscard]] std::string to_text(double value);

/// The exact value, as `printf("%a")` writes it in the C locale, "-0x1.b0187ccff2edbp+4", whatever the locale
/// is.
[[nodiscard]] std::string hex_float(double value);

}  // namespace hyrax

// A JSON document as it was written: order of keys, repeated keys and the sign of zero are kept.
//
// Numbers are read correctly rounded and written shortest-round-trip, whatever the locale. The
// parsing itself is nlohmann-json's, seen by json.cpp alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hyrax {

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(int value) : value_(static_cast<std::int64_t>(value)) {}
  Json(std::int64_t value) : value_(value) {}
  Json(std::uint64_t value) : value_(value) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(Array value) : value_(std::move(value)) {}
  Json(Object value) : value_(std::move(value)) {}

  /// The value, if it is of that type; else nullptr.
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
    return get<double>() != nullptr || get<std::int64_t>() != nullptr || get<std::uint64_t>() != nullptr;
  }
  /// REQUIRES: is_number().
  [[nodiscard]] double number() const;

  /// The first member of that key; nullptr where there is none or this is no object.
  [[nodiscard]] const Json* find(std::string_view key) const;

 private:
  // A non-negative integer up to 2^64 - 1 is unsigned, a negative one signed, every other number
  // (and -0) a double.
  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value_;
};

/// Reads a whole document.
/// ERRORS: Failure(bad_input) "SOURCE: line L, column C: ..." for anything that is not one JSON
/// text in UTF-8 without byte-order mark, a number beyond binary64, or nesting beyond 100 levels.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& source);

/// How a document is laid out: everything in one line, or members and elements on lines of their
/// own down to a depth, the rest in one line.
struct JsonLayout {
  int depth_indented = 0;
};

/// The document as text, without a last newline. A non-finite number becomes the string "NaN",
/// "Infinity" or "-Infinity".
[[nodiscard]] std::string to_text(const Json& json, JsonLayout layout = {});

/// Shortest decimal text that reads back to the same double.
[[nodiscard]] std::string to_text(double value);

/// A JSON Pointer (RFC 6901) with one reference token more.
[[nodiscard]] std::string pointer_to(const std::string& pointer, std::string_view token);

/// Sets the value at a JSON Pointer; missing objects on the way are made, "-" appends to an array.
/// ERRORS: Failure(bad_input) for what is no pointer, is deeper than a document may nest, or leads
/// through something that has no members.
void set_at(Json& document, std::string_view pointer, Json value);

}  // namespace hyrax

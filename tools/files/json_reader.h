// Reads values from a Json document, and lists all errors in it.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/json.h"

namespace hyrax {

/// An error: its JSON Pointer, and a sentence with rule, value and remedy.
struct JsonProblem {
  std::string pointer;
  std::string sentence;
};

/// All errors in a document; of very many the first ones, so that the report is not many times larger than
/// the document.
struct JsonProblems {
  static constexpr std::size_t kListedMax = 200'000;
  std::vector<JsonProblem> listed;
  std::size_t count = 0;

  /// ERRORS: Failure(bad_input) with a line for every error, "SOURCE: POINTER: SENTENCE".
  void throw_if_any(const std::string& source) const;
};

struct NumberRule {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool excludes_low = false;
};

/// One place of a document. A missing one is not an error; see `is_there`.
class JsonPlace {
 public:
  JsonPlace(const Json* json, std::string pointer, JsonProblems& problems)
      : json_(json), pointer_(std::move(pointer)), problems_(&problems) {}

  [[nodiscard]] bool is_there() const { return json_ != nullptr; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  /// Errors in the whole document so far.
  [[nodiscard]] std::size_t problem_count() const { return problems_->count; }
  /// Adds an error: a sentence, or a rule, to which " (found VALUE)" is appended.
  void wrong(const std::string& sentence) const;
  /// Returns nothing, as the reader of a value then does. REQUIRES: is_there().
  std::nullopt_t breaks_rule(const std::string& rule) const;

  /// Adds the error of a key that is none of those.
  void unknown_key(std::string_view key, const std::vector<std::string_view>& allowed) const;
  /// Whether this is an object; if not, and for unknown and duplicate keys, adds an error.
  [[nodiscard]] bool is_object_of(const std::vector<std::string_view>& keys) const;
  /// Visits the members of an object of any keys; if it is none, and for duplicate keys, adds an error.
  void each_member(const std::function<void(const std::string& key, const JsonPlace& here)>& visit) const;
  [[nodiscard]] JsonPlace member(std::string_view key) const;
  /// The member; adds an error if it is missing.
  [[nodiscard]] JsonPlace required(std::string_view key) const;
  /// The array; nullptr, and an error, if this is anything else.
  [[nodiscard]] const Json::Array* array() const;
  /// REQUIRES: this is an array of more than `index` elements.
  [[nodiscard]] JsonPlace element(std::size_t index) const;

  // Values; nothing, and an error, if they break the rule. Nothing if the place is missing.
  [[nodiscard]] std::optional<double> number(const NumberRule& rule = {}) const;
  [[nodiscard]] std::optional<std::int64_t> integer(std::int64_t low, std::int64_t high) const;
  /// A number from 1 on; one above `most` is read as `most`.
  [[nodiscard]] std::optional<std::int64_t> positive_integer(std::int64_t most) const;
  [[nodiscard]] std::optional<std::uint64_t> seed() const;
  [[nodiscard]] std::optional<bool> boolean() const;
  [[nodiscard]] std::optional<std::string> text() const;

  [[nodiscard]] const Json* json() const { return json_; }

 private:
  const Json* json_;
  std::string pointer_;
  JsonProblems* problems_;
};

}  // namespace hyrax

// Reads values out of a Json document and keeps a list of everything that is wrong with it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/json.h"

namespace hyrax {

/// A wrong place: its JSON Pointer, and a sentence with rule, value and remedy.
struct JsonProblem {
  std::string pointer;
  std::string sentence;
};

/// Everything that is wrong with a document; of very many places the first ones, so that a document
/// of nothing but errors does not make a report many times its size.
struct JsonProblems {
  static constexpr std::size_t kListedMax = 200'000;
  std::vector<JsonProblem> listed;
  std::size_t count = 0;
};

/// Which numbers may stand.
struct NumberRule {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool excludes_low = false;
};

/// One place of a document. What is not there is not wrong: ask `is_there`.
class JsonPlace {
 public:
  JsonPlace(const Json* json, std::string pointer, JsonProblems& problems)
      : json_(json), pointer_(std::move(pointer)), problems_(&problems) {}

  [[nodiscard]] bool is_there() const { return json_ != nullptr; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  /// Says what is wrong here; appends ", is VALUE" where the sentence is a rule.
  void wrong(const std::string& sentence) const;
  void breaks_rule(const std::string& rule) const;

  /// Whether this is an object; complains of that, and of unknown and repeated keys.
  [[nodiscard]] bool is_object_of(std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] JsonPlace member(std::string_view key) const;
  /// The member, of which a complaint is made if it is missing.
  [[nodiscard]] JsonPlace required(std::string_view key) const;
  /// The elements of an array; complains of anything else.
  [[nodiscard]] std::optional<std::vector<JsonPlace>> elements() const;

  // Values; nothing, and a complaint, where they break the rule. Nothing where nothing is there.
  [[nodiscard]] std::optional<double> number(const NumberRule& rule = {}) const;
  [[nodiscard]] std::optional<std::int64_t> integer(std::int64_t low, std::int64_t high) const;
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

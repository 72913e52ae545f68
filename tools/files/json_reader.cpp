#include "tools/files/json_reader.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_set>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/printable.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

constexpr std::size_t kSuggestionsMax = 100;
constexpr std::size_t kSuggestedFromMax = 20;

// REQUIRES: a rule with a low limit.
std::string sentence_of(const NumberRule& rule) {
  const std::string low = to_text(rule.low), high = to_text(rule.high);
  if (!std::isfinite(rule.high)) return "must be at least " + low;
  return rule.excludes_low ? "must be greater than " + low + " and at most " + high
                           : "must be " + low + " .. " + high;
}

}  // namespace

void JsonProblems::throw_if_any(const std::string& source) const {
  if (count == 0) return;
  std::string sentences;
  for (const JsonProblem& problem : listed)
    sentences.append(sentences.empty() ? "" : "\n")
        .append(printable(source + ": " + (problem.pointer.empty() ? "/" : problem.pointer) + ": " +
                          problem.sentence));
  if (const std::size_t more = count - listed.size(); more > 0)
    sentences.append("\n").append(printable(source)).append(": and " + std::to_string(more) + " more errors");
  refuse_input(sentences);
}

void JsonPlace::wrong(const std::string& sentence) const {
  if (problems_->count++ < JsonProblems::kListedMax) problems_->listed.push_back({pointer_, sentence});
}

std::nullopt_t JsonPlace::breaks_rule(const std::string& rule) const {
  assert(is_there());
  wrong(rule + " (found " + shortened(to_text(*json_)) + ")");
  return std::nullopt;
}

void JsonPlace::unknown_key(std::string_view key, const std::vector<std::string_view>& allowed) const {
  // A suggestion takes time in proportion to the keys that are allowed.
  const bool are_many = allowed.size() > kSuggestedFromMax && problem_count() > kSuggestionsMax;
  wrong(are_many ? "unknown key" : unknown_word("key", key, allowed));
}

bool JsonPlace::is_object_of(const std::vector<std::string_view>& keys) const {
  each_member([&](const std::string& key, const JsonPlace& here) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) here.unknown_key(key, keys);
  });
  return is_there() && json_->get<Json::Object>() != nullptr;
}

void JsonPlace::each_member(
    const std::function<void(const std::string& key, const JsonPlace& here)>& visit) const {
  if (!is_there()) return;
  const auto* object = json_->get<Json::Object>();
  if (object == nullptr) {
    breaks_rule("must be an object");
    return;
  }
  std::unordered_set<std::string_view> seen;
  for (const auto& [key, value] : *object) {
    const JsonPlace here(&value, pointer_to(pointer_, key), *problems_);
    visit(key, here);
    if (!seen.insert(key).second) here.wrong("duplicate key; keep one of the two");
  }
}

JsonPlace JsonPlace::member(std::string_view key) const {
  return {is_there() ? json_->find(key) : nullptr, pointer_to(pointer_, key), *problems_};
}

JsonPlace JsonPlace::required(std::string_view key) const {
  const JsonPlace here = member(key);
  if (!here.is_there()) here.wrong("is missing");
  return here;
}

const Json::Array* JsonPlace::array() const {
  if (!is_there()) return nullptr;
  const auto* array = json_->get<Json::Array>();
  if (array == nullptr) breaks_rule("must be an array");
  return array;
}

JsonPlace JsonPlace::element(std::size_t index) const {
  assert(array() != nullptr && index < array()->size());
  return {&(*json_->get<Json::Array>())[index], pointer_to(pointer_, std::to_string(index)), *problems_};
}

std::optional<double> JsonPlace::number(const NumberRule& rule) const {
  if (!is_there()) return std::nullopt;
  if (!json_->is_number()) return breaks_rule("must be a number");
  const double value = json_->number();
  const bool is_low = rule.excludes_low ? !(value > rule.low) : !(value >= rule.low);
  if (!std::isfinite(value) || is_low || value > rule.high)
    return breaks_rule(is_low || std::isfinite(rule.high) ? sentence_of(rule) : "number is too large");
  return value;
}

std::optional<std::int64_t> JsonPlace::integer(std::int64_t low, std::int64_t high) const {
  if (!is_there()) return std::nullopt;
  // The bounds are far below 2^53, so they are exact as doubles.
  if (!json_->is_whole() || json_->number() < static_cast<double>(low) ||
      json_->number() > static_cast<double>(high))
    return breaks_rule("must be a whole number " + std::to_string(low) + " .. " + std::to_string(high));
  return static_cast<std::int64_t>(json_->number());
}

std::optional<std::int64_t> JsonPlace::positive_integer(std::int64_t most) const {
  if (!is_there()) return std::nullopt;
  if (json_->is_whole() && json_->number() >= 1.0)
    return static_cast<std::int64_t>(std::min(json_->number(), static_cast<double>(most)));
  return breaks_rule("must be a whole number of at least 1");
}

std::optional<std::uint64_t> JsonPlace::seed() const {
  if (!is_there()) return std::nullopt;
  if (const auto* whole = json_->get<std::uint64_t>()) return *whole;
  const auto* real = json_->get<double>();
  if (real != nullptr && json_->is_whole() && *real >= 0.0 && *real < 0x1p64)
    return static_cast<std::uint64_t>(*real);
  return breaks_rule("must be a whole number 0 .. 18446744073709551615");
}

std::optional<bool> JsonPlace::boolean() const {
  if (!is_there()) return std::nullopt;
  if (const auto* truth = json_->get<bool>()) return *truth;
  return breaks_rule("must be true or false");
}

std::optional<std::string> JsonPlace::text() const {
  if (!is_there()) return std::nullopt;
  if (const auto* text = json_->get<std::string>()) return *text;
  return breaks_rule("must be a text in double quotes");
}

}  // namespace hyrax

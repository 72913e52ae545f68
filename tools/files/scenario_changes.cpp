#include "tools/files/scenario_changes.h"

#include <algorithm>
#include <vector>

#include "tools/files/json.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

constexpr std::size_t kListedMax = 4;

std::string value_text(const Json* value) { return value == nullptr ? "none" : to_text(*value); }

class PointerChanges {
 public:
  void compare(const std::string& pointer, const Json* from, const Json* to) {
    if (from != nullptr && to != nullptr) {
      const auto* const object_from = from->get<Json::Object>();
      const auto* const object_to = to->get<Json::Object>();
      if (object_from != nullptr && object_to != nullptr) return compare(pointer, *object_from, *object_to);
      const auto* const array_from = from->get<Json::Array>();
      const auto* const array_to = to->get<Json::Array>();
      if (array_from != nullptr && array_to != nullptr) return compare(pointer, *array_from, *array_to);
    }
    if (value_text(from) != value_text(to))
      changes_.push_back(pointer + " " + value_text(from) + " -> " + value_text(to));
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    for (std::size_t change = 0; change < std::min(changes_.size(), kListedMax); ++change)
      text += (text.empty() ? "" : "; ") + changes_[change];
    if (changes_.size() > kListedMax)
      text += "; and " + std::to_string(changes_.size() - kListedMax) + " more";
    return text;
  }

 private:
  void compare(const std::string& pointer, const Json::Object& from, const Json::Object& to) {
    const auto find = [](const Json::Object& object, const std::string& key) -> const Json* {
      const auto member = std::ranges::find(object, key, &Json::Object::value_type::first);
      return member == object.end() ? nullptr : &member->second;
    };
    for (const auto& [key, value] : from) compare(pointer_to(pointer, key), &value, find(to, key));
    for (const auto& [key, value] : to)
      if (find(from, key) == nullptr) compare(pointer_to(pointer, key), nullptr, &value);
  }
  void compare(const std::string& pointer, const Json::Array& from, const Json::Array& to) {
    const auto element = [](const Json::Array& array, std::size_t index) {
      return index < array.size() ? &array[index] : nullptr;
    };
    for (std::size_t index = 0; index < std::max(from.size(), to.size()); ++index)
      compare(pointer_to(pointer, std::to_string(index)), element(from, index), element(to, index));
  }

  std::vector<std::string> changes_;
};

}  // namespace

std::string scenario_changes(const Scenario& from, const Scenario& to) {
  if (plays_the_same(from, to)) return "";
  const Json before = to_json(without_texts(from));
  const Json after = to_json(without_texts(to));
  PointerChanges changes;
  changes.compare("", &before, &after);
  return changes.text();
}

}  // namespace hyrax

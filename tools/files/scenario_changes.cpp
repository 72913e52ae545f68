#include "tools/files/scenario_changes.h"

#include <algorithm>
#include <vector>

#include "tools/files/json_pointer.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

constexpr std::size_t kListedMax = 4;

std::string value_text(const Json* value) { return value == nullptr ? "none" : to_text(*value); }

template <class Container>
const Container* get(const Json* value) {
  return value == nullptr ? nullptr : value->get<Container>();
}

const Json* element_of(const Json::Array& array, std::size_t index) {
  return index < array.size() ? &array[index] : nullptr;
}

void add_changes(const std::string& pointer, const Json* from, const Json* to,
                 std::vector<std::string>& changes) {
  const auto *const members_from = get<Json::Object>(from), *const members_to = get<Json::Object>(to);
  const auto *const array_from = get<Json::Array>(from), *const array_to = get<Json::Array>(to);
  if (members_from != nullptr && members_to != nullptr) {
    for (const auto& [key, value] : *members_from)
      add_changes(pointer_to(pointer, key), &value, to->find(key), changes);
    for (const auto& [key, value] : *members_to)
      if (from->find(key) == nullptr) add_changes(pointer_to(pointer, key), nullptr, &value, changes);
  } else if (array_from != nullptr && array_to != nullptr) {
    for (std::size_t index = 0; index < std::max(array_from->size(), array_to->size()); ++index)
      add_changes(pointer_to(pointer, std::to_string(index)), element_of(*array_from, index),
                  element_of(*array_to, index), changes);
  } else if (value_text(from) != value_text(to)) {
    changes.push_back(pointer + " " + value_text(from) + " -> " + value_text(to));
  }
}

}  // namespace

std::string scenario_changes(const Scenario& from, const Scenario& to) {
  return plays_the_same(from, to) ? ""
                                  : json_changes(to_json(without_texts(from)), to_json(without_texts(to)));
}

std::string json_changes(const Json& from, const Json& to) {
  std::vector<std::string> changes;
  add_changes("", &from, &to, changes);
  std::string text;
  for (std::size_t change = 0; change < std::min(changes.size(), kListedMax); ++change)
    text += (text.empty() ? "" : "; ") + changes[change];
  if (changes.size() > kListedMax) text += "; and " + std::to_string(changes.size() - kListedMax) + " more";
  return text;
}

}  // namespace hyrax

// Reads the description of a core as files have it.
#include <algorithm>
#include <limits>

#include "tools/described/value_json.h"

namespace hyrax {
namespace {

// A member that is missing, or null, is none.
bool is_given(const JsonPlace& place) { return place.is_there() && !place.json()->is_null(); }

template <class Read>
void each_element(const JsonPlace& list, const Read& read) {
  const Json::Array* const array = is_given(list) ? list.array() : nullptr;
  for (std::size_t index = 0; array != nullptr && index < array->size(); ++index) read(list.element(index));
}

std::string text_in(const JsonPlace& object, std::string_view key) {
  return object.required(key).text().value_or("");
}

// A core's own may be what no scenario holds: not finite.
Word word_in(const JsonPlace& place, const ValueInfo& value) {
  using Limits = std::numeric_limits<double>;
  const auto* const text = place.json()->get<std::string>();
  for (const double number : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    if (text != nullptr && is_floating(value.type) && *text == value_text(value, word_of(number)))
      return word_of(number);
  return read_value(place, value).value_or(0);
}

ValueInfo value_in(const JsonPlace& object) {
  ValueInfo value{.name = text_in(object, "name")};
  const std::string type = text_in(object, "type");
  const auto found = std::ranges::find(kValueTypeNames, type);
  if (found == kValueTypeNames.end())
    object.wrong("unknown type");
  else
    value.type = static_cast<ValueType>(found - kValueTypeNames.begin());
  const JsonPlace unit = object.member("unit");
  if (is_given(unit)) value.unit = unit.text().value_or("");
  each_element(object.member("names"),
               [&](const JsonPlace& name) { value.names.push_back(name.text().value_or("")); });
  if (const JsonPlace initial = object.member("default"); is_given(initial))
    value.initial = word_in(initial, value);
  const JsonPlace limits = object.member("limits");
  if (is_given(limits) && limits.array() != nullptr && limits.array()->size() == 2)
    value.limits = {word_in(limits.element(0), value), word_in(limits.element(1), value)};
  return value;
}

std::vector<ValueInfo> values_in(const JsonPlace& list) {
  std::vector<ValueInfo> values;
  each_element(list, [&](const JsonPlace& object) { values.push_back(value_in(object)); });
  return values;
}

}  // namespace

Description parse_description(const std::string& text, const std::string& core, const std::string& source) {
  const Json document = parse_json(text, source);
  JsonProblems problems;
  const JsonPlace root(&document, "", problems);
  Description description{.core = core};
  description.state.values = values_in(root.required("state"));
  description.inputs.values = values_in(root.member("inputs"));
  description.parameters.values = values_in(root.member("parameters"));
  description.outputs.values = values_in(root.member("outputs"));
  each_element(root.member("actions"), [&](const JsonPlace& action) {
    description.actions.push_back({text_in(action, "name"), values_in(action.member("arguments"))});
  });
  each_element(root.member("contacts"),
               [&](const JsonPlace& contact) { description.contacts.push_back(text_in(contact, "name")); });
  each_element(root.member("properties"), [&](const JsonPlace& property) {
    description.properties.push_back({text_in(property, "name"), text_in(property, "kind") == "always"});
  });
  problems.throw_if_any(source);
  return description;
}

}  // namespace hyrax

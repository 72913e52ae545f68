#include "tools/described/value_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

// The word of a number of the document, if the type can hold it.
std::optional<Word> exact_word(const Json& json, ValueType type) {
  const std::array<Word, 2> range = range_of(type);
  if (is_floating(type)) {
    const double value = json.number();
    const double rounded =
        type == ValueType::float32 ? static_cast<double>(static_cast<float>(value)) : value;
    return std::isfinite(rounded) ? std::optional(word_of(rounded)) : std::nullopt;
  }
  if (!json.is_whole()) return std::nullopt;
  const bool is_negative = json.number() < 0.0;
  Word bits = 0;
  if (const auto* const negative = json.get<std::int64_t>())
    bits = static_cast<Word>(*negative);
  else if (const auto* const positive = json.get<std::uint64_t>())
    bits = *positive;
  else if (const double value = *json.get<double>(); value > -0x1p63 && value < 0x1p64)
    bits = is_negative ? static_cast<Word>(static_cast<std::int64_t>(value)) : static_cast<Word>(value);
  else
    return std::nullopt;
  if (is_negative != (is_signed_integer(type) && static_cast<std::int64_t>(bits) < 0)) return std::nullopt;
  return is_less(type, bits, range[0]) || is_less(type, range[1], bits) ? std::nullopt : std::optional(bits);
}

// A text as the document would have it, without names.
std::string number_text(ValueType type, Word word) {
  return to_text(value_json({.name = {}, .type = type}, word));
}

// Of a float the number as it is written: what rounds to a limit may be beyond it.
bool is_within(const Json& json, ValueType type, Word word, const std::array<Word, 2>& limits) {
  if (!is_floating(type)) return !is_less(type, word, limits[0]) && !is_less(type, limits[1], word);
  const auto limit = [&](Word end) { return value_json({.name = {}, .type = type}, end).number(); };
  return limit(limits[0]) <= json.number() && json.number() <= limit(limits[1]);
}

std::optional<Word> read_name(const JsonPlace& here, const ValueInfo& value) {
  const auto name = *here.text();
  for (std::size_t number = 0; number < value.names.size(); ++number)
    if (value.names[number] == name) return number;
  here.wrong(unknown_word("value", name, {value.names.begin(), value.names.end()}));
  return std::nullopt;
}

Json list_json(const ValueList& list, bool has_defaults) {
  return list_of(list.values, [&](const ValueInfo& value) {
    Json::Object object{{"name", value.name},
                        {"type", name_of(value.type)},
                        {"unit", value.unit.empty() ? Json() : Json(value.unit)}};
    if (has_defaults) object.emplace_back("default", value_json(value, value.initial));
    Json limits;
    if (value.limits)
      limits = Json::Array{value_json(value, (*value.limits)[0]), value_json(value, (*value.limits)[1])};
    object.emplace_back("limits", std::move(limits));
    object.emplace_back(
        "names", value.names.empty() ? Json() : Json(Json::Array(value.names.begin(), value.names.end())));
    return object;
  });
}

Json action_json(const ActionInfo& action) {
  const auto argument_json = [](const ValueInfo& argument) {
    return Json::Object{{"name", argument.name},
                        {"type", name_of(argument.type)},
                        {"unit", argument.unit.empty() ? Json() : Json(argument.unit)}};
  };
  return Json::Object{{"name", action.name}, {"arguments", list_of(action.arguments, argument_json)}};
}

}  // namespace

std::array<Word, 2> range_of(ValueType type) {
  return visit_stored(type, []<class Number>(Number) {
    using Limits = std::numeric_limits<Number>;
    return std::array{word_of(Limits::lowest()), word_of(Limits::max())};
  });
}

std::array<Word, 2> file_limits(const ValueInfo& value) {
  if (!value.names.empty()) return {0, value.names.size() - 1};
  std::array<Word, 2> limits = range_of(value.type);
  for (std::size_t end = 0; end < 2; ++end)  // A limit may be infinite, a number of a file not.
    if (value.limits && !is_less(value.type, (*value.limits)[end], limits[0]) &&
        !is_less(value.type, limits[1], (*value.limits)[end]))
      limits[end] = (*value.limits)[end];
  return limits;
}

Json value_json(const ValueInfo& value, Word word) {
  if (word < value.names.size()) return value.names[word];
  if (value.type == ValueType::boolean) return word != 0;
  if (is_floating(value.type)) return shown_number_of(value.type, word);
  if (is_signed_integer(value.type) && static_cast<std::int64_t>(word) < 0)
    return static_cast<std::int64_t>(word);
  return word;
}

std::string value_text(const ValueInfo& value, Word word) {
  const Json json = value_json(value, word);
  const auto* const text = json.get<std::string>();
  std::string shown = text != nullptr ? *text : to_text(json);
  std::erase(shown, '"');  // Of "Infinity".
  return shown;
}

std::optional<Word> read_value(const JsonPlace& here, const ValueInfo& value, bool is_limited) {
  if (!here.is_there()) return std::nullopt;
  if (value.type == ValueType::boolean) {
    const auto truth = here.boolean();
    return truth ? std::optional(word_of(*truth)) : std::nullopt;
  }
  if (!value.names.empty() && here.json()->get<std::string>() != nullptr) return read_name(here, value);
  const std::array<Word, 2> limits = is_limited ? file_limits(value) : range_of(value.type);
  const auto word = here.json()->is_number() ? exact_word(*here.json(), value.type) : std::nullopt;
  if (word && is_within(*here.json(), value.type, *word, limits)) return word;
  if (limits == range_of(ValueType::float64) && here.json()->is_number())
    return here.breaks_rule("number is too large");
  std::string rule = is_floating(value.type) ? "must be a number" : "must be a whole number";
  if (limits != range_of(ValueType::float64))
    rule += " " + number_text(value.type, limits[0]) + " .. " + number_text(value.type, limits[1]);
  if (!value.names.empty())
    rule += ", or one of " + listed(std::vector<std::string_view>(value.names.begin(), value.names.end()));
  return here.breaks_rule(rule);
}

Json description_json(const Description& description) {
  return Json::Object{
      {"state", list_json(description.state, true)},
      {"inputs", list_json(description.inputs, true)},
      {"parameters", list_json(description.parameters, true)},
      {"outputs", list_json(description.outputs, false)},
      {"actions", list_of(description.actions, action_json)},
      {"contacts", list_of(description.contacts,
                           [](const std::string& name) {
                             return Json::Object{{"name", name}};
                           })},
      {"properties", list_of(description.properties, [](const PropertyInfo& property) {
         return Json::Object{{"name", property.name}, {"kind", property.is_always ? "always" : "sometimes"}};
       })}};
}

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

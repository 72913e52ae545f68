#include "sim/described/description.h"

#include <charconv>
#include <iterator>
#include <set>
#include <span>

namespace hyrax {

double shown_number_of(ValueType type, Word word) {
  double number = number_of(type, word);
  if (type != ValueType::float32) return number;
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value_of<float>(word));
  std::from_chars(text, written.ptr, number);
  return number;
}

std::string unit_of(std::string_view name) {
  while (true) {  // The last part that is no number.
    const std::size_t dot = name.rfind('.');
    const std::string_view part = name.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (dot == std::string_view::npos || part.find_first_not_of("0123456789") != std::string_view::npos) {
      name = part;
      break;
    }
    name = name.substr(0, dot);
  }
  struct Unit {
    std::string_view ending;
    std::string_view text;
    bool has_rates;
  };
  constexpr std::array<Unit, 6> kUnits = {{{"_px", "px", true},
                                           {"_m", "m", true},
                                           {"_rad", "rad", true},
                                           {"_deg", "deg", true},
                                           {"_s", "s", false},
                                           {"_hz", "Hz", false}}};
  // A rate of another word has no unit, though it ends in "_s".
  const bool is_per_s2 = name.ends_with("_per_s2");
  const bool is_per_s = name.ends_with("_per_s");
  if (is_per_s2) name.remove_suffix(7);
  if (is_per_s) name.remove_suffix(6);
  const std::string_view rate = is_per_s2 ? "/s^2" : is_per_s ? "/s" : "";
  for (const Unit& unit : kUnits)
    if (name.ends_with(unit.ending) && (rate.empty() || unit.has_rates))
      return std::string(unit.text).append(rate);
  return {};
}

namespace {

constexpr std::string_view kDigits = "0123456789";

bool is_word(std::string_view text) {
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

/// Parts joined by dots; one after the first may be a number.
bool is_name(std::string_view name) {
  for (bool is_first = true;; is_first = false) {
    const std::size_t dot = name.find('.');
    const std::string_view part = name.substr(0, dot);
    const bool is_number = !part.empty() && part.find_first_not_of(kDigits) == std::string_view::npos;
    if (!is_word(part) && (is_first || !is_number)) return false;
    if (dot == std::string_view::npos) return true;
    name.remove_prefix(dot + 1);
  }
}

/// Names that are unique among one another.
class NameSpace {
 public:
  NameSpace(std::span<const std::string_view> reserved, std::vector<std::string>& faults)
      : reserved_(reserved), faults_(faults) {}

  void add(std::string_view kind, const std::string& name) {
    const std::string named = std::string(kind) + " '" + name + "': ";
    if (!is_name(name))
      faults_.push_back(named + "a name is parts [a-z][a-z0-9_]* joined by dots");
    else if (std::find(reserved_.begin(), reserved_.end(), name) != reserved_.end())
      faults_.push_back(named + "the name is reserved");
    else if (!names_.insert(name).second)
      faults_.push_back(named + "duplicate name");
  }

 private:
  std::span<const std::string_view> reserved_;
  std::vector<std::string>& faults_;
  std::set<std::string> names_ = {};
};

void add_range_faults(std::string_view kind, const ValueInfo& value, std::vector<std::string>& faults) {
  const std::string named = std::string(kind) + " '" + value.name + "': ";
  if (value.limits) {
    const auto& [low, high] = *value.limits;
    // Not as "high < low", which a NaN is not.
    if (!is_less(value.type, low, high) && low != high)
      faults.push_back(named + "the low limit is above the high one");
    else if (kind != "output" &&
             (is_less(value.type, value.initial, low) || is_less(value.type, high, value.initial)))
      faults.push_back(named + "the default is outside the limits");
  }
  if (value.names.empty()) return;
  if (kind != "output" && value.initial >= value.names.size())
    faults.push_back(named + "the default has no name");
  if (std::set(value.names.begin(), value.names.end()).size() < value.names.size())
    faults.push_back(named + "two of its values have the same name");
  if (std::ranges::find(value.names, "") != value.names.end())
    faults.push_back(named + "a value's name is empty");
}

/// What of a list has to be the same in two descriptions.
struct Item {
  std::string name = {};
  std::string type = {};
  bool operator==(const Item&) const = default;
};

Item item_of(const ValueInfo& value) {
  Item item = {value.name, std::string(name_of(value.type))};
  for (const std::string& name : value.names) item.type.append(" ").append(name);
  return item;
}
Item item_of(const ActionInfo& action) {
  Item item = {action.name, "an action of"};
  for (const ValueInfo& argument : action.arguments)
    item.type.append(" ").append(argument.name).append(" ").append(name_of(argument.type));
  if (action.arguments.empty()) item.type += " no arguments";
  return item;
}
Item item_of(const std::string& contact) { return {contact, "a contact"}; }
Item item_of(const PropertyInfo& property) {
  return {property.name, property.is_always ? "always" : "sometimes"};
}

template <class List>
std::vector<Item> items_of(const List& list) {
  std::vector<Item> items;
  items.reserve(list.size());
  for (const auto& each : list) items.push_back(item_of(each));
  return items;
}

const Item* find(const std::vector<Item>& items, const std::string& name) {
  const auto at =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  return at == items.end() ? nullptr : &*at;
}

std::string difference(std::string_view kind, const std::vector<Item>& before,
                       const std::vector<Item>& after) {
  if (before == after) return {};
  const auto named = [&](const Item& item) { return std::string(kind) + " " + item.name; };
  std::vector<Item> removed;
  std::vector<Item> added;
  for (const Item& item : before)
    if (find(after, item.name) == nullptr) removed.push_back(item);
  for (const Item& item : after)
    if (find(before, item.name) == nullptr) added.push_back(item);
  if (removed.size() == 1 && added.size() == 1 && removed[0].type == added[0].type)
    return named(removed[0]) + " was renamed " + added[0].name;
  if (!added.empty()) return named(added[0]) + " was added";
  if (!removed.empty()) return named(removed[0]) + " was removed";
  for (const Item& item : after)
    if (const Item& old = *find(before, item.name); old.type != item.type)
      return named(item) + " is " + item.type + ", was " + old.type;
  const auto moved = std::mismatch(after.begin(), after.end(), before.begin()).first;
  return named(*moved) + " has another place in its list";
}

// Words of a name end at '_' and dots.
std::vector<std::size_t> word_begins(std::string_view name) {
  std::vector<std::size_t> begins = {0};
  for (std::size_t at = 0; at < name.size(); ++at)
    if (name[at] == '_' || name[at] == '.') begins.push_back(at + 1);
  return begins;
}
std::string_view word_at(std::string_view name, std::size_t begin) {
  return name.substr(begin, name.find_first_of("_.", begin) - begin);
}

}  // namespace

std::vector<PositionPair> position_pairs(const Description& description) {
  const std::vector<ValueInfo>& values = description.state.values;
  std::vector<PositionPair> pairs;
  for (std::size_t x = 0; x < values.size(); ++x) {
    if (values[x].unit != "px") continue;
    const std::string& name = values[x].name;
    for (const std::size_t word : word_begins(name)) {
      if (word_at(name, word) != "x") continue;
      std::string other = name;
      other[word] = 'y';
      const auto y = std::find_if(values.begin(), values.end(),
                                  [&](const ValueInfo& value) { return value.name == other; });
      if (y == values.end()) continue;
      std::string common;
      for (const std::size_t begin : word_begins(name)) {
        if (begin == word || word_at(name, begin) == "px") continue;
        if (!common.empty()) common += name[begin - 1];
        common += word_at(name, begin);
      }
      pairs.push_back({x, static_cast<std::size_t>(y - values.begin()), common});
      break;
    }
  }
  return pairs;
}

std::vector<std::string> faults_of(const Description& description) {
  std::vector<std::string> faults;
  constexpr std::string_view kReservedValues[] = {"t", "dt", "step"};
  constexpr std::string_view kReservedActions[] = {"step", "at_s", "set", "hitch", "hold", "go"};
  NameSpace values(kReservedValues, faults);
  const auto add_values = [&](std::string_view kind, const ValueList& list) {
    for (const ValueInfo& value : list.values) {
      values.add(kind, value.name);
      add_range_faults(kind, value, faults);
    }
  };
  if (description.state.values.empty()) faults.emplace_back("state: declares no value");
  add_values("state", description.state);
  add_values("input", description.inputs);
  add_values("parameter", description.parameters);
  for (const std::string& contact : description.contacts) values.add("contact", contact);
  add_values("output", description.outputs);
  NameSpace actions(kReservedActions, faults);
  for (const ActionInfo& action : description.actions) {
    actions.add("action", action.name);
    NameSpace arguments({}, faults);
    for (const ValueInfo& argument : action.arguments)
      arguments.add("argument of " + action.name, argument.name);
  }
  std::set<std::string> properties;
  for (const PropertyInfo& property : description.properties)
    if (property.name.empty() || !properties.insert(property.name).second)
      faults.push_back("property '" + property.name +
                       "': " + (property.name.empty() ? "has no name" : "duplicate name"));
  return faults;
}

std::string description_difference(const Description& before, const Description& after) {
  const auto of = [](std::string_view kind, const auto& a, const auto& b) {
    return difference(kind, items_of(a), items_of(b));
  };
  for (const std::string& text :
       {of("value", before.state.values, after.state.values),
        of("input", before.inputs.values, after.inputs.values),
        of("parameter", before.parameters.values, after.parameters.values),
        of("output", before.outputs.values, after.outputs.values),
        of("action", before.actions, after.actions), of("contact", before.contacts, after.contacts),
        of("property", before.properties, after.properties)})
    if (!text.empty()) return text;
  return {};
}

}  // namespace hyrax

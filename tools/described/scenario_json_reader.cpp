#include "tools/described/scenario_json.h"

#include <algorithm>
#include <unordered_map>

#include "tools/files/event_reader.h"
#include "tools/files/scenario_list.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// An event's keys: those that every core has, then its actions.
std::vector<std::string_view> event_names(const Description& description) {
  std::vector<std::string_view> names(kOwnEventNames.begin(), kOwnEventNames.end());
  for (const ActionInfo& action : description.actions) names.push_back(action.name);
  return names;
}

std::vector<std::string_view> names_of(const std::vector<ValueInfo>& values) {
  std::vector<std::string_view> names;
  for (const ValueInfo& value : values) names.push_back(value.name);
  return names;
}

// Places of names; a list of hundreds of values is looked up in every event.
using Places = std::unordered_map<std::string_view, std::size_t>;

Places places_of(const std::vector<std::string_view>& names) {
  Places places;
  for (std::size_t place = 0; place < names.size(); ++place) places.emplace(names[place], place);
  return places;
}

// Reads one document.
class Reader {
 public:
  Reader(const Description& description, const JsonPlace& document)
      : description_(description),
        document_(document),
        state_(places_of(names_of(description.state.values))),
        inputs_(places_of(names_of(description.inputs.values))),
        parameters_(places_of(names_of(description.parameters.values))) {}

  DescribedScenario read(const std::string& fallback_name) {
    if (is_of_other_core(document_, description_.core)) return {};
    if (!document_.is_object_of({"$schema", "format", "name", "description", "core", "parameters", "inputs",
                                 "start", "clock", "steps", "duration_s", "events", "record", "expect"}))
      return {};
    read_names(document_, fallback_name, scenario_);
    scenario_.core = document_.member("core").text();
    frames_ = read_frames(document_, scenario_);
    read_members(document_.member("parameters"), description_.parameters.values, parameters_,
                 [&](std::size_t place, const JsonPlace& here) {
                   add(scenario_.parameters, place, read_value(here, description_.parameters.values[place]));
                 });
    read_members(document_.member("inputs"), description_.inputs.values, inputs_,
                 [&](std::size_t place, const JsonPlace& here) { read_input(place, here); });
    read_members(document_.member("start"), description_.state.values, state_,
                 [&](std::size_t place, const JsonPlace& here) {
                   add(scenario_.start, place, read_value(here, description_.state.values[place]));
                 });
    sort(scenario_.parameters);
    sort(scenario_.inputs);
    std::ranges::sort(scenario_.input_arrays, {}, &InputArray::input);
    sort(scenario_.start);
    read_all_events();
    read_record(document_, scenario_);
    if (const JsonPlace expect = document_.member("expect"); expect.is_there()) read_expect(expect);
    return std::move(scenario_);
  }

 private:
  // Calls read(PLACE, HERE) for each member that is a name of the list.
  static void read_members(const JsonPlace& here, const std::vector<ValueInfo>& values, const Places& places,
                           const auto& read) {
    if (!here.is_there() || !here.is_object_of(names_of(values))) return;
    for (const auto& [name, json] : *here.json()->get<Json::Object>())
      if (const auto place = places.find(name); place != places.end()) read(place->second, here.member(name));
  }

  static void add(std::vector<GivenValue>& given, std::size_t place, std::optional<Word> word) {
    if (word) given.emplace_back(place, *word);
  }
  static void sort(std::vector<GivenValue>& given) { std::ranges::sort(given, {}, &GivenValue::first); }

  void read_input(std::size_t place, const JsonPlace& here) {
    const ValueInfo& value = description_.inputs.values[place];
    const auto* const array = here.json()->get<Json::Array>();
    if (array == nullptr) return add(scenario_.inputs, place, read_value(here, value));
    if (frames_.steps && array->size() != static_cast<std::size_t>(*frames_.steps))
      here.wrong("must hold a value for each frame, " + std::to_string(*frames_.steps) + " (found " +
                 std::to_string(array->size()) + ")");
    InputArray input{place, {}};
    input.words.reserve(array->size());
    for (std::size_t frame = 0; frame < array->size(); ++frame)
      input.words.push_back(read_value(here.element(frame), value).value_or(0));
    scenario_.input_arrays.push_back(std::move(input));
  }

  SetValues read_set(const JsonPlace& here) {
    SetValues set;
    std::vector<std::string_view> names = names_of(description_.inputs.values);
    for (const ValueInfo& value : description_.state.values) names.push_back(value.name);
    here.each_member([&](const std::string& name, const JsonPlace& member) {
      if (const auto input = inputs_.find(name); input != inputs_.end()) {
        const bool has_array = std::ranges::any_of(
            scenario_.input_arrays, [&](const InputArray& array) { return array.input == input->second; });
        if (has_array) member.wrong("has an array in /inputs, which sets it before every frame");
        add(set.inputs, input->second, read_value(member, description_.inputs.values[input->second]));
      } else if (const auto place = state_.find(name); place != state_.end()) {
        add(set.state, place->second, read_value(member, description_.state.values[place->second]));
      } else if (parameters_.contains(name)) {
        member.wrong("is a parameter, which is fixed during a run; give it in /parameters");
      } else {
        member.unknown_key(name, names);
      }
    });
    sort(set.inputs);
    sort(set.state);
    return set;
  }

  Act read_act(const JsonPlace& here, std::size_t action) const {
    Act act{action, {}};
    const std::vector<ValueInfo>& arguments = description_.actions[action].arguments;
    if (!here.is_object_of(names_of(arguments))) return act;
    for (const ValueInfo& argument : arguments)
      act.arguments.push_back(read_value(here.required(argument.name), argument).value_or(0));
    return act;
  }

  DescribedAction read_action(const JsonPlace& here, std::size_t kind) {
    if (kind >= kOwnEventNames.size()) return read_act(here, kind - kOwnEventNames.size());
    const std::string_view name = kOwnEventNames[kind];
    if (name == "set") return read_set(here);
    if (name == "hitch") {
      static_cast<void>(here.is_object_of({"dt_s"}));
      return Hitch{here.required("dt_s").number(kFrameRule).value_or(0.0)};
    }
    static_cast<void>(here.is_object_of({}));
    return name == "hold" ? DescribedAction(Hold{}) : DescribedAction(Go{});
  }

  void read_all_events() {
    const JsonPlace here = document_.member("events");
    const auto* const array = here.is_there() ? here.json()->get<Json::Array>() : nullptr;
    scenario_.events.resize(array == nullptr ? 0 : array->size());
    const auto read = [&](const JsonPlace& place, std::size_t event, std::size_t kind) {
      const DescribedAction& action = scenario_.events[event].action = read_action(place, kind);
      EventEffect effect;
      if (std::holds_alternative<Hold>(action)) effect.hold = EventEffect::Hold::held;
      if (std::holds_alternative<Go>(action)) effect.hold = EventEffect::Hold::let_go;
      if (const auto* const hitch = std::get_if<Hitch>(&action)) effect.hitch_dt_s = hitch->dt_s;
      return effect;
    };
    const std::vector<EventTime> times =
        read_events(here, frames_, scenario_.clock,
                    {.names = event_names(description_),
                     .held_already = "frames are held already; give go first",
                     .not_held = "frames are not held; give hold first",
                     .read = read});
    for (std::size_t event = 0; event < times.size(); ++event)
      scenario_.events[event].when = times[event].when;
  }

  // Both ends of what a value may be at the end.
  std::optional<std::array<Word, 2>> read_final(const JsonPlace& here, const ValueInfo& value) const {
    const auto* const array = here.json()->get<Json::Array>();
    const bool may_be_exact = !is_floating(value.type);
    if (array == nullptr && may_be_exact) {
      const auto word = read_value(here, value, false);
      return word ? std::optional(std::array{*word, *word}) : std::nullopt;
    }
    const std::string rule = "must be [low, high] with low <= high";
    const std::string or_exact = may_be_exact ? ", or an exact value" : "";
    if (array == nullptr || array->size() != 2 || value.type == ValueType::boolean)
      return here.breaks_rule(value.type == ValueType::boolean ? "must be true or false" : rule + or_exact);
    const auto low = read_value(here.element(0), value, false);
    const auto high = read_value(here.element(1), value, false);
    if (!low || !high) return std::nullopt;
    if (is_less(value.type, *high, *low)) return here.breaks_rule(rule + or_exact);
    return std::array{*low, *high};
  }

  void read_expect(const JsonPlace& here) {
    DescribedExpect& expect = scenario_.expect.emplace();
    if (!here.is_object_of({"finite", "final", "contacts", "at_rest_since_s", "state_hash"})) return;
    expect.finite = here.member("finite").boolean();
    read_members(here.member("final"), description_.state.values, state_,
                 [&](std::size_t place, const JsonPlace& member) {
                   if (const auto ends = read_final(member, description_.state.values[place]))
                     expect.final.emplace_back(place, *ends);
                 });
    std::ranges::sort(expect.final, {}, [](const auto& rule) { return rule.first; });
    const JsonPlace contacts = here.member("contacts");
    if (contacts.is_there() &&
        contacts.is_object_of({description_.contacts.begin(), description_.contacts.end()}))
      for (std::size_t contact = 0; contact < description_.contacts.size(); ++contact)
        if (const auto count = read_count(contacts.member(description_.contacts[contact])))
          expect.contacts.emplace_back(contact, *count);
    const JsonPlace rest = here.member("at_rest_since_s");
    expect.at_rest_since_s = read_time(rest);
    if (rest.is_there() && !has_px(description_))
      rest.wrong("needs a state value in px; the core " + description_.core +
                 " has none (names that end in _px)");
    expect.state_hash = read_hash(here.member("state_hash"));
  }

  const Description& description_;
  JsonPlace document_;
  Places state_;
  Places inputs_;
  Places parameters_;
  DescribedScenario scenario_ = {};
  FramesRead frames_ = {};
};

}  // namespace

DescribedScenario to_described_scenario(const Description& description, const Json& document,
                                        const std::string& source, const std::string& fallback_name) {
  JsonProblems problems;
  DescribedScenario scenario = Reader(description, JsonPlace(&document, "", problems)).read(fallback_name);
  problems.throw_if_any(source);
  return scenario;
}

DescribedScenario load_described_scenario(const Description& description, const std::string& path,
                                          const std::vector<Override>& overrides) {
  return to_described_scenario(description, load_scenario_document(path, overrides), path,
                               fallback_name(path));
}

DescribedScenario parse_described_scenario(const Description& description, std::string_view text,
                                           const std::string& source) {
  return to_described_scenario(description, parse_json(text, source), source, "");
}

std::vector<DescribedScenario> library_or_defaults(const Description& description) {
  std::vector<DescribedScenario> library;
  std::vector<Failure> without_any;
  if (is_folder("scenarios"))
    for (const std::string& path : list_scenarios({"scenarios"}, without_any))
      library.push_back(load_described_scenario(description, path));
  if (!library.empty()) return library;
  DescribedScenario defaults;
  defaults.name = "defaults";
  defaults.clock.base = FixedRate{60.0};
  defaults.length = std::int64_t{600};
  return {defaults};
}

}  // namespace hyrax

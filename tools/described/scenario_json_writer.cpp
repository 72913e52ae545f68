#include <algorithm>

#include "tools/described/scenario_json.h"
#include "tools/files/scenario_head.h"

namespace hyrax {
namespace {

void add_values(const std::vector<ValueInfo>& values, const std::vector<GivenValue>& given,
                Json::Object& object) {
  for (const auto& [place, word] : given)
    object.emplace_back(values[place].name, value_json(values[place], word));
}

void add_list(std::string_view key, Json::Object list, Json::Object& document) {
  if (!list.empty()) document.emplace_back(key, std::move(list));
}

Json::Object inputs_json(const ValueList& inputs, const DescribedScenario& scenario) {
  // Values and arrays in declared order together.
  std::vector<std::pair<std::size_t, Json>> members;
  for (const auto& [place, word] : scenario.inputs)
    members.emplace_back(place, value_json(inputs.values[place], word));
  for (const InputArray& array : scenario.input_arrays)
    members.emplace_back(array.input, list_of(array.words, [&](Word word) {
                           return value_json(inputs.values[array.input], word);
                         }));
  std::ranges::sort(members, {}, [](const auto& member) { return member.first; });
  Json::Object object;
  for (auto& [place, json] : members) object.emplace_back(inputs.values[place].name, std::move(json));
  return object;
}

Json expect_json(const Description& description, const DescribedExpect& expect) {
  Json::Object object;
  add_member(object, "finite", expect.finite);
  Json::Object final;
  for (const auto& [place, ends] : expect.final) {
    const ValueInfo& value = description.state.values[place];
    const bool is_exact = ends[0] == ends[1] && !is_floating(value.type);
    final.emplace_back(value.name, is_exact
                                       ? value_json(value, ends[0])
                                       : Json::Array{value_json(value, ends[0]), value_json(value, ends[1])});
  }
  add_list("final", std::move(final), object);
  Json::Object contacts;
  for (const auto& [contact, count] : expect.contacts)
    contacts.emplace_back(description.contacts[contact], count_json(count));
  add_list("contacts", std::move(contacts), object);
  if (expect.at_rest_since_s) object.emplace_back("at_rest_since_s", time_json(*expect.at_rest_since_s));
  add_member(object, "state_hash", expect.state_hash);
  return object;
}

}  // namespace

Json event_json(const Description& description, const DescribedAction& action) {
  Json::Object object;
  if (const auto* const set = std::get_if<SetValues>(&action)) {
    add_values(description.inputs.values, set->inputs, object);
    add_values(description.state.values, set->state, object);
  } else if (const auto* const hitch = std::get_if<Hitch>(&action)) {
    object.emplace_back("dt_s", hitch->dt_s);
  } else if (const auto* const act = std::get_if<Act>(&action)) {
    const ActionInfo& info = description.actions[act->action];
    for (std::size_t argument = 0; argument < act->arguments.size(); ++argument)
      object.emplace_back(info.arguments[argument].name,
                          value_json(info.arguments[argument], act->arguments[argument]));
  }
  return Json::Object{{event_name(description, action), std::move(object)}};
}

Json to_json(const Description& description, const DescribedScenario& scenario) {
  Json::Object document;
  add_names(scenario, document);
  add_member(document, "core", scenario.core);
  Json::Object parameters;
  add_values(description.parameters.values, scenario.parameters, parameters);
  add_list("parameters", std::move(parameters), document);
  add_list("inputs", inputs_json(description.inputs, scenario), document);
  Json::Object start;
  add_values(description.state.values, scenario.start, start);
  add_list("start", std::move(start), document);
  add_frames(scenario, document);
  Json::Array events;
  for (const DescribedEvent& event : scenario.events) {
    Json::Object object = event_time_json(event.when);
    const Json action = event_json(description, event.action);
    object.push_back(action.get<Json::Object>()->front());
    events.emplace_back(std::move(object));
  }
  if (!events.empty()) document.emplace_back("events", std::move(events));
  add_record(scenario, document);
  if (scenario.expect) document.emplace_back("expect", expect_json(description, *scenario.expect));
  return document;
}

}  // namespace hyrax

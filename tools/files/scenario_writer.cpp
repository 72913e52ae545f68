#include "tools/files/scenario_writer.h"

#include "sim/scenario/numbers.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_head.h"

namespace hyrax {
namespace {

using Object = Json::Object;

Json to_json(const Size& size) {
  return Object{{"width_px", static_cast<std::int64_t>(size.width_px)},
                {"height_px", static_cast<std::int64_t>(size.height_px)}};
}

// @param visit_all calls its argument for each number, as visit_numbers does.
Json numbers_json(const auto& visit_all) {
  Json object = Object();
  visit_all([&](std::string_view path, const NumberField& field) {
    set_at(object, std::string("/").append(path),
           std::visit([](const auto* at) { return Json(*at); }, field.at));
  });
  return object;
}

Json to_json(const Event& event) {
  Object object = event_time_json(event.when);
  Action action = event.action;
  object.emplace_back(name_of(event.action),
                      numbers_json([&](const auto& visit) { visit_numbers(action, visit); }));
  return object;
}

Json to_json(const Expect& expect) {
  Object object;
  add_member(object, "in_bounds", expect.in_bounds);
  add_member(object, "finite", expect.finite);
  if (expect.final_x_px) object.emplace_back("final_x_px", interval_json(*expect.final_x_px));
  if (expect.final_y_px) object.emplace_back("final_y_px", interval_json(*expect.final_y_px));
  if (expect.at_rest_since_s) object.emplace_back("at_rest_since_s", time_json(*expect.at_rest_since_s));
  Object contacts;
  for (const Wall wall : kWalls)
    if (const auto count = expect.contacts[wall]) contacts.emplace_back(name_of(wall), count_json(*count));
  if (!contacts.empty()) object.emplace_back("contacts", contacts);
  add_member(object, "state_hash", expect.state_hash);
  add_member(object, "implementation_px_max", expect.implementation_px_max);
  add_member(object, "truncation_px_max", expect.truncation_px_max);
  add_member(object, "energy_drift_rel_max", expect.energy_drift_rel_max);
  return object;
}

}  // namespace

Json to_json(const Scenario& scenario) {
  Object document;
  add_names(scenario, document);
  document.emplace_back("window", to_json(scenario.window));
  document.emplace_back("sprite", to_json(scenario.sprite));
  Position start = scenario.start;
  Velocity velocity = scenario.start_velocity;
  document.emplace_back("start",
                        numbers_json([&](const auto& visit) { visit_start(start, velocity, visit); }));
  add_frames(scenario, document);
  Json::Array events;
  for (const Event& event : scenario.events) events.push_back(to_json(event));
  if (!events.empty()) document.emplace_back("events", std::move(events));
  Object parameters;
  for (const auto& [name, value] : scenario.parameters) parameters.emplace_back(name, value);
  if (!parameters.empty()) document.emplace_back("parameters", std::move(parameters));
  add_record(scenario, document);
  if (scenario.expect) document.emplace_back("expect", to_json(*scenario.expect));
  return document;
}

std::string scenario_file_text(const Scenario& scenario) { return to_text(to_json(scenario), 1) + "\n"; }

}  // namespace hyrax

#include "tools/files/scenario_writer.h"

#include <cmath>

#include "sim/scenario/numbers.h"
#include "tools/files/json_pointer.h"
#include "tools/files/scenario_members.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

using Object = Json::Object;

Json to_json(const Size& size) {
  return Object{{"width_px", static_cast<std::int64_t>(size.width_px)},
                {"height_px", static_cast<std::int64_t>(size.height_px)}};
}
Json to_json(const Jitter& jitter) {
  const JitterRule& rule = kJitterRules.at(static_cast<std::size_t>(jitter.kind));
  return Object{{"kind", rule.kind}, {std::string(rule.amount_key), jitter.amount}, {"seed", jitter.seed}};
}

Json to_json(const Clock& clock) {
  Object object;
  if (const auto* rate = std::get_if<FixedRate>(&clock.base)) object.emplace_back("rate_hz", rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&clock.base)) object.emplace_back("dt_s", step->dt_s);
  if (const auto* trace = std::get_if<RecordedSteps>(&clock.base))
    object.emplace_back("dt_s", Json::Array(trace->dt_s.begin(), trace->dt_s.end()));
  if (clock.jitter) object.emplace_back("jitter", to_json(*clock.jitter));
  return object;
}

Json action_json(Action action) {
  Json object = Object();
  visit_numbers(action, [&](std::string_view path, const NumberField& field) {
    set_at(object, std::string("/").append(path),
           std::visit([](const auto* at) { return Json(*at); }, field.at));
  });
  return object;
}

Json to_json(const Event& event) {
  Object object;
  if (const auto* step = std::get_if<std::int64_t>(&event.when))
    object.emplace_back("step", *step);
  else
    object.emplace_back("at_s", std::get<double>(event.when));
  object.emplace_back(name_of(event.action), action_json(event.action));
  return object;
}

Json to_json(const Interval& interval) { return Json::Array{interval.low, interval.high}; }

Json count_to_json(const Interval& interval) {
  return interval.low == interval.high ? Json(interval.high) : to_json(interval);
}

// [v, v] must not become the number v, which means "at the latest".
Json time_to_json(const Interval& interval) {
  return std::isinf(interval.low) ? Json(interval.high) : to_json(interval);
}

template <class Value>
void add(Object& object, std::string_view key, const std::optional<Value>& value) {
  if (value) object.emplace_back(key, Json(*value));
}

Json to_json(const Expect& expect) {
  Object object;
  add(object, "in_bounds", expect.in_bounds);
  add(object, "finite", expect.finite);
  if (expect.final_x_px) object.emplace_back("final_x_px", to_json(*expect.final_x_px));
  if (expect.final_y_px) object.emplace_back("final_y_px", to_json(*expect.final_y_px));
  if (expect.at_rest_since_s) object.emplace_back("at_rest_since_s", time_to_json(*expect.at_rest_since_s));
  Object contacts;
  for (const Wall wall : kWalls)
    if (const auto count = expect.contacts[wall]) contacts.emplace_back(name_of(wall), count_to_json(*count));
  if (!contacts.empty()) object.emplace_back("contacts", contacts);
  add(object, "state_hash", expect.state_hash);
  add(object, "implementation_px_max", expect.implementation_px_max);
  add(object, "truncation_px_max", expect.truncation_px_max);
  add(object, "energy_drift_rel_max", expect.energy_drift_rel_max);
  return object;
}

}  // namespace

Json to_json(const Scenario& scenario) {
  Object document;
  add(document, "$schema", scenario.schema);
  document.emplace_back("format", kScenarioFormat);
  document.emplace_back("name", scenario.name);
  add(document, "description", scenario.description);
  document.emplace_back("window", to_json(scenario.window));
  document.emplace_back("sprite", to_json(scenario.sprite));
  document.emplace_back("start", Object{{"x_px", scenario.start.x_px},
                                        {"y_px", scenario.start.y_px},
                                        {"vx_px_per_s", scenario.start_velocity.vx_px_per_s},
                                        {"vy_px_per_s", scenario.start_velocity.vy_px_per_s}});
  document.emplace_back("clock", to_json(scenario.clock));
  if (const auto* steps = std::get_if<std::int64_t>(&scenario.length)) document.emplace_back("steps", *steps);
  if (const auto* duration_s = std::get_if<double>(&scenario.length))
    document.emplace_back("duration_s", *duration_s);
  Json::Array events;
  for (const Event& event : scenario.events) events.push_back(to_json(event));
  if (!events.empty()) document.emplace_back("events", std::move(events));
  if (scenario.record_every != 1) document.emplace_back("record", Object{{"every", scenario.record_every}});
  if (scenario.expect) document.emplace_back("expect", to_json(*scenario.expect));
  return document;
}

std::string scenario_file_text(const Scenario& scenario) { return to_text(to_json(scenario), 1) + "\n"; }

}  // namespace hyrax

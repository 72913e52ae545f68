#include "tools/files/scenario_reader.h"

#include <algorithm>

#include "sim/scenario/numbers.h"
#include "tools/files/event_reader.h"
#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/json_reader.h"
#include "tools/files/scenario_head.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// Errors are added to the problems of the place; the values in question are then 0 or missing.

Size read_size(const JsonPlace& here, std::int64_t low_px, std::int64_t high_px) {
  if (!here.is_object_of({"width_px", "height_px"})) return {};
  return {static_cast<std::int32_t>(here.required("width_px").integer(low_px, high_px).value_or(0)),
          static_cast<std::int32_t>(here.required("height_px").integer(low_px, high_px).value_or(0))};
}

Size read_window(const JsonPlace& here) { return read_size(here, 0, kWindowSideMax_px); }
Size read_sprite(const JsonPlace& here) { return read_size(here, kSpriteSideMin_px, kSpriteSideMax_px); }

Resize read_resize(const JsonPlace& here) {
  Resize resize;
  if (!here.is_object_of({"window", "sprite"})) return resize;
  if (const JsonPlace window = here.member("window"); window.is_there()) resize.window = read_window(window);
  if (const JsonPlace sprite = here.member("sprite"); sprite.is_there()) resize.sprite = read_sprite(sprite);
  if (!resize.window && !resize.sprite) here.wrong("must hold window, sprite or both");
  return resize;
}

// @param visit_all calls its argument for each number that the place holds, as visit_numbers does.
void read_numbers(const JsonPlace& here, std::initializer_list<std::string_view> optional_keys,
                  const auto& visit_all) {
  std::vector<std::string_view> keys;
  visit_all([&](std::string_view key, const NumberField&) { keys.push_back(key); });
  if (!here.is_object_of(keys)) return;
  visit_all([&](std::string_view key, const NumberField& field) {
    const bool is_optional = std::ranges::find(optional_keys, key) != optional_keys.end();
    const JsonPlace place = is_optional ? here.member(key) : here.required(key);
    field.set(place.number({field.low, field.high}).value_or(0.0));
  });
}

Action read_action(const JsonPlace& here, std::size_t kind) {
  Action action = make_action(kind);
  if (auto* const resize = std::get_if<Resize>(&action)) {
    *resize = read_resize(here);
    return action;
  }
  read_numbers(here, {}, [&](const auto& visit) { visit_numbers(action, visit); });
  return action;
}

Expect read_expect(const JsonPlace& here) {
  Expect expect;
  if (!here.is_object_of({"in_bounds", "finite", "final_x_px", "final_y_px", "at_rest_since_s", "contacts",
                          "state_hash", "implementation_px_max", "truncation_px_max",
                          "energy_drift_rel_max"}))
    return expect;
  expect.in_bounds = here.member("in_bounds").boolean();
  expect.finite = here.member("finite").boolean();
  expect.final_x_px = read_interval(here.member("final_x_px"));
  expect.final_y_px = read_interval(here.member("final_y_px"));
  expect.at_rest_since_s = read_time(here.member("at_rest_since_s"));
  if (const JsonPlace contacts = here.member("contacts");
      contacts.is_there() && contacts.is_object_of({kWallNames.begin(), kWallNames.end()}))
    for (const Wall wall : kWalls) expect.contacts[wall] = read_count(contacts.member(name_of(wall)));
  expect.state_hash = read_hash(here.member("state_hash"));
  expect.implementation_px_max = here.member("implementation_px_max").number(kNotNegativeRule);
  expect.truncation_px_max = here.member("truncation_px_max").number(kNotNegativeRule);
  expect.energy_drift_rel_max = here.member("energy_drift_rel_max").number(kNotNegativeRule);
  return expect;
}

void read_events(const JsonPlace& here, const FramesRead& frames, Scenario& scenario) {
  const auto* const array = here.is_there() ? here.json()->get<Json::Array>() : nullptr;
  scenario.events.resize(array == nullptr ? 0 : array->size());
  const auto read = [&](const JsonPlace& place, std::size_t event, std::size_t kind) {
    const Action& action = scenario.events[event].action = read_action(place, kind);
    EventEffect effect;
    if (std::holds_alternative<Grab>(action)) effect.hold = EventEffect::Hold::held;
    if (std::holds_alternative<Release>(action)) effect.hold = EventEffect::Hold::let_go;
    if (const auto* const hitch = std::get_if<Hitch>(&action)) effect.hitch_dt_s = hitch->dt_s;
    return effect;
  };
  const std::vector<EventTime> times =
      read_events(here, frames, scenario.clock,
                  {.names = {kActionNames.begin(), kActionNames.end()},
                   .held_already = "the sprite is held already; release it first",
                   .not_held = "the sprite is not held; grab it first",
                   .read = read});
  for (std::size_t event = 0; event < times.size(); ++event) scenario.events[event].when = times[event].when;
}

// Which names there are the core says.
void read_parameters(const JsonPlace& here, Scenario& scenario) {
  here.each_member([&](const std::string& name, const JsonPlace& place) {
    scenario.parameters.push_back({name, place.number({-kParameterMax, kParameterMax}).value_or(0.0)});
  });
  std::ranges::sort(scenario.parameters, {}, &Parameter::name);
}

Scenario read_document(const JsonPlace& document, const std::string& fallback_name) {
  Scenario scenario;
  if (is_of_other_core(document, "")) return scenario;
  if (!document.is_object_of({"$schema", "format", "name", "description", "window", "sprite", "start",
                              "clock", "steps", "duration_s", "events", "parameters", "record", "expect"}))
    return scenario;
  read_names(document, fallback_name, scenario);
  scenario.window = read_window(document.required("window"));
  scenario.sprite = read_sprite(document.required("sprite"));
  read_numbers(document.required("start"), {"vx_px_per_s", "vy_px_per_s"},
               [&](const auto& visit) { visit_start(scenario.start, scenario.start_velocity, visit); });
  read_events(document.member("events"), read_frames(document, scenario), scenario);
  read_parameters(document.member("parameters"), scenario);
  read_record(document, scenario);
  if (const JsonPlace expect = document.member("expect"); expect.is_there())
    scenario.expect = read_expect(expect);
  return scenario;
}

// JSON if it is valid JSON, else the text itself.
Json value_of(const Override& given) {
  try {
    return parse_json(given.value, given.pointer);
  } catch (const Failure&) {
    return given.value;
  }
}

}  // namespace

Scenario to_scenario(const Json& document, const std::string& source, const std::string& fallback_name) {
  JsonProblems problems;
  Scenario scenario = read_document(JsonPlace(&document, "", problems), fallback_name);
  problems.throw_if_any(source);
  return scenario;
}

void replace_value(Json& document, const Override& given, const std::string& source) {
  set_at(document, given.pointer, value_of(given), source);
}

std::string read_scenario_text(const std::string& path) {
  const std::string_view suffix = file_name(path).extension;
  if (suffix == ".json" && is_device_or_pipe(path))
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: is a pipe or a device");
  if (suffix == ".JSON") refuse_input(path + ": unknown suffix (found .JSON); allowed: .json");
  return read_text_file(path == "-" ? "/dev/stdin" : path);
}

Json load_scenario_document(const std::string& path, const std::vector<Override>& overrides) {
  Json document = parse_json(read_scenario_text(path), path);
  for (const Override& given : overrides) replace_value(document, given, path);
  return document;
}

std::string fallback_name(const std::string& path) {
  return path == "-" ? "stdin" : std::string(file_name(path).stem);
}

Scenario load_scenario(const std::string& path, const std::vector<Override>& overrides) {
  return to_scenario(load_scenario_document(path, overrides), path, fallback_name(path));
}

Scenario parse_scenario_file(std::string_view text, const std::string& path) {
  return to_scenario(parse_json(text, path), path, std::string(file_name(path).stem));
}

Scenario parse_scenario(std::string_view text, const std::string& source) {
  return to_scenario(parse_json(text, source), source, "");
}

}  // namespace hyrax

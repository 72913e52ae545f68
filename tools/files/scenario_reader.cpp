#include "tools/files/scenario_reader.h"

#include <algorithm>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/json_reader.h"
#include "tools/files/scenario_head.h"
#include "tools/files/scenario_members.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

void read_start(const JsonPlace& here, Scenario& scenario) {
  if (!here.is_object_of({"x_px", "y_px", "vx_px_per_s", "vy_px_per_s"})) return;
  constexpr NumberRule kCoordinateRule{-kCoordinateMax_px, kCoordinateMax_px};
  constexpr NumberRule kSpeedRule{-kSpeedMax_px_per_s, kSpeedMax_px_per_s};
  scenario.start = {here.required("x_px").number(kCoordinateRule).value_or(0.0),
                    here.required("y_px").number(kCoordinateRule).value_or(0.0)};
  scenario.start_velocity = {here.member("vx_px_per_s").number(kSpeedRule).value_or(0.0),
                             here.member("vy_px_per_s").number(kSpeedRule).value_or(0.0)};
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
  read_start(document.required("start"), scenario);
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

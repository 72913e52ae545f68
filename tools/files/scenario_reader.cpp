#include "tools/files/scenario_reader.h"

#include <algorithm>
#include <cassert>

#include "sim/scenario/frame_clock.h"
#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/json_reader.h"
#include "tools/files/path.h"
#include "tools/files/scenario_members.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

constexpr NumberRule kFrameRule{0.0, kFrameMax_s};

bool is_name(const std::string& name) {
  const auto is_allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= kNameLengthMax && std::all_of(name.begin(), name.end(), is_allowed);
}

void read_format(const JsonPlace& here) {
  const auto format = here.text();
  if (format && *format != kScenarioFormat) here.wrong(unknown_word("format", *format, {kScenarioFormat}));
}

std::string read_name(const JsonPlace& here, const std::string& fallback) {
  if (here.is_there()) {
    const auto name = here.text();
    if (name && !is_name(*name)) here.breaks_rule("must be 1 .. 64 of the characters a-z, 0-9 and -");
    return name.value_or("");
  }
  if (!is_name(fallback))
    here.wrong("is missing, and the file name is not a name (found " + fallback +
               "); a name is 1 .. 64 of the characters a-z, 0-9 and -");
  return fallback;
}

void read_start(const JsonPlace& here, Scenario& scenario) {
  if (!here.is_object_of({"x_px", "y_px", "vx_px_per_s", "vy_px_per_s"})) return;
  constexpr NumberRule kCoordinateRule{-kCoordinateMax_px, kCoordinateMax_px};
  constexpr NumberRule kSpeedRule{-kSpeedMax_px_per_s, kSpeedMax_px_per_s};
  scenario.start = {here.required("x_px").number(kCoordinateRule).value_or(0.0),
                    here.required("y_px").number(kCoordinateRule).value_or(0.0)};
  scenario.start_velocity = {here.member("vx_px_per_s").number(kSpeedRule).value_or(0.0),
                             here.member("vy_px_per_s").number(kSpeedRule).value_or(0.0)};
}

Jitter read_jitter(const JsonPlace& here) {
  if (here.json()->get<Json::Object>() == nullptr) {
    here.breaks_rule("must be an object");
    return {};
  }
  const auto seed = here.required("seed").seed();
  const auto kind = here.required("kind").text();
  const auto rule = std::ranges::find_if(kJitterRules, [&](const JitterRule& r) { return kind == r.kind; });
  if (rule == kJitterRules.end()) {
    std::vector<std::string_view> kinds;
    for (const JitterRule& each : kJitterRules) kinds.push_back(each.kind);
    if (kind) here.member("kind").wrong(unknown_word("value", *kind, kinds));
    // The keys of all kinds are allowed, each with its own rule.
    static_cast<void>(here.is_object_of({"kind", "fraction", "sigma_s", "probability", "seed"}));
    for (const JitterRule& each : kJitterRules)
      static_cast<void>(here.member(each.amount_key).number(each.amount));
    return {};
  }
  static_cast<void>(here.is_object_of({"kind", rule->amount_key, "seed"}));
  return {static_cast<Jitter::Kind>(rule - kJitterRules.begin()),
          here.required(rule->amount_key).number(rule->amount).value_or(0.0), seed.value_or(0)};
}

// REQUIRES: an array. It may have millions of frames, so no list of their places is made.
RecordedSteps read_trace(const JsonPlace& here) {
  assert(here.array() != nullptr);
  RecordedSteps trace;
  const std::size_t frames = here.array()->size();
  if (frames == 0) here.wrong("must hold at least one dt (found [])");
  trace.dt_s.reserve(frames);
  for (std::size_t frame = 0; frame < frames; ++frame)
    trace.dt_s.push_back(here.element(frame).number(kFrameRule).value_or(0.0));
  return trace;
}

void read_clock(const JsonPlace& here, Clock& clock) {
  if (!here.is_object_of({"rate_hz", "dt_s", "jitter"})) return;
  const JsonPlace rate = here.member("rate_hz");
  const JsonPlace dt = here.member("dt_s");
  if (rate.is_there() == dt.is_there()) here.wrong("must hold exactly one of rate_hz and dt_s");
  if (rate.is_there()) {
    const auto rate_hz = rate.number({0.0, kRateMax_hz, true});
    if (rate_hz && 1.0 / *rate_hz > kFrameMax_s) rate.breaks_rule("must make frames of at most 1e9 s");
    clock.base = FixedRate{rate_hz.value_or(1.0)};
  }
  if (dt.is_there() && dt.json()->get<Json::Array>() != nullptr)
    clock.base = read_trace(dt);
  else if (dt.is_there())
    clock.base = FixedStep{dt.number(kFrameRule).value_or(1.0)};
  const JsonPlace jitter = here.member("jitter");
  if (!jitter.is_there()) return;
  if (std::holds_alternative<RecordedSteps>(clock.base))
    jitter.wrong("not allowed with an array dt_s, which gives every dt");
  clock.jitter = read_jitter(jitter);
}

// The number of frames if it is known: of a duration only if the clock is valid.
std::optional<std::int64_t> read_length(const JsonPlace& document, bool is_clock_good, Scenario& scenario) {
  const JsonPlace steps = document.member("steps");
  const JsonPlace duration = document.member("duration_s");
  const auto count = steps.integer(0, kStepsMax);
  const auto duration_s = duration.number(kNotNegativeRule);
  if (count) scenario.length = *count;
  if (const auto* trace = std::get_if<RecordedSteps>(&scenario.clock.base)) {
    const auto frames = static_cast<std::int64_t>(trace->dt_s.size());
    if (duration.is_there())
      duration.wrong("not allowed with an array dt_s, whose length gives the number of steps");
    if (count && *count != frames)
      steps.breaks_rule("must be the length of the array dt_s, " + std::to_string(frames));
    return frames;
  }
  const bool is_one = steps.is_there() != duration.is_there();
  // If the clock is empty both may be missing: an array would give the number of frames.
  const JsonPlace clock = document.member("clock");
  const bool is_clock_given = clock.member("rate_hz").is_there() || clock.member("dt_s").is_there();
  if (!is_one && (is_clock_given || steps.is_there()))
    document.wrong("must hold exactly one of steps and duration_s");
  if (!is_one || steps.is_there()) return is_one ? count : std::nullopt;
  if (!duration_s || !is_clock_good) return std::nullopt;
  scenario.length = *duration_s;
  if (!(base_dt_s(scenario.clock) > 0.0))
    duration.wrong("needs frames of dt > 0; give steps instead");
  else if (step_count(scenario) > kStepsMax)
    duration.breaks_rule("must make at most 1e12 frames");
  else
    return step_count(scenario);
  return std::nullopt;
}

void read_record(const JsonPlace& here, Scenario& scenario) {
  if (!here.is_there() || !here.is_object_of({"every"})) return;
  scenario.record_every = here.member("every").positive_integer(kStepsMax).value_or(1);
}

Scenario read_document(const JsonPlace& document, const std::string& fallback_name) {
  Scenario scenario;
  if (!document.is_object_of({"$schema", "format", "name", "description", "window", "sprite", "start",
                              "clock", "steps", "duration_s", "events", "record", "expect"}))
    return scenario;
  scenario.schema = document.member("$schema").text();
  read_format(document.required("format"));
  scenario.name = read_name(document.member("name"), fallback_name);
  scenario.description = document.member("description").text();
  scenario.window = read_window(document.required("window"));
  scenario.sprite = read_sprite(document.required("sprite"));
  read_start(document.required("start"), scenario);
  const std::size_t problems_before_clock = document.problem_count();
  read_clock(document.required("clock"), scenario.clock);
  const bool is_clock_good = document.problem_count() == problems_before_clock;
  const auto steps = read_length(document, is_clock_good, scenario);
  read_events(document.member("events"), is_clock_good, steps, scenario);
  read_record(document.member("record"), scenario);
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

Scenario load_scenario(const std::string& path, const std::vector<Override>& overrides) {
  Json document = parse_json(read_scenario_text(path), path);
  for (const Override& given : overrides) replace_value(document, given, path);
  return to_scenario(document, path, path == "-" ? "stdin" : std::string(file_name(path).stem));
}

Scenario parse_scenario_file(std::string_view text, const std::string& path) {
  return to_scenario(parse_json(text, path), path, std::string(file_name(path).stem));
}

Scenario parse_scenario(std::string_view text, const std::string& source) {
  return to_scenario(parse_json(text, source), source, "");
}

}  // namespace hyrax

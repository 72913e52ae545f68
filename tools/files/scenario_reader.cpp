#include "tools/files/scenario_reader.h"

#include <algorithm>
#include <filesystem>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tools/files/failure.h"
#include "tools/files/json_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr NumberRule kCoordinate{-kCoordinateMax_px, kCoordinateMax_px};
constexpr NumberRule kSpeed{-kSpeedMax_px_per_s, kSpeedMax_px_per_s};
constexpr NumberRule kFrame{0.0, kFrameMax_s};
constexpr NumberRule kNotNegative{0.0};

bool is_name(const std::string& name) {
  const auto may_stand = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= kNameLengthMax && std::all_of(name.begin(), name.end(), may_stand);
}

void read_format(const JsonPlace& here) {
  const auto format = here.text();
  if (format && *format != kScenarioFormat)
    here.breaks_rule("must be a format this program knows: \"" + std::string(kScenarioFormat) + "\"");
}

std::string read_name(const JsonPlace& here, const std::string& fallback) {
  if (here.is_there()) {
    const auto name = here.text();
    if (name && !is_name(*name)) here.breaks_rule("must be 1 .. 64 of the characters a-z, 0-9 and -");
    return name.value_or("");
  }
  if (!is_name(fallback))
    here.wrong("is missing, and the file's name '" + fallback +
               "' cannot stand for it; a name is 1 .. 64 of the characters a-z, 0-9 and -");
  return fallback;
}

Size read_size(const JsonPlace& here, std::int64_t low_px, std::int64_t high_px) {
  if (!here.is_object_of({"width_px", "height_px"})) return {};
  return {static_cast<std::int32_t>(here.required("width_px").integer(low_px, high_px).value_or(0)),
          static_cast<std::int32_t>(here.required("height_px").integer(low_px, high_px).value_or(0))};
}
Size read_window(const JsonPlace& here) { return read_size(here, 0, kWindowSideMax_px); }
Size read_sprite(const JsonPlace& here) { return read_size(here, kSpriteSideMin_px, kSpriteSideMax_px); }

Position read_position(const JsonPlace& here) {
  return {here.required("x_px").number(kCoordinate).value_or(0.0),
          here.required("y_px").number(kCoordinate).value_or(0.0)};
}

void read_start(const JsonPlace& here, Scenario& scenario) {
  if (!here.is_object_of({"x_px", "y_px", "vx_px_per_s", "vy_px_per_s"})) return;
  scenario.start = read_position(here);
  scenario.start_velocity = {here.member("vx_px_per_s").number(kSpeed).value_or(0.0),
                             here.member("vy_px_per_s").number(kSpeed).value_or(0.0)};
}

Velocity read_velocity(const JsonPlace& here) {
  if (!here.is_object_of({"vx_px_per_s", "vy_px_per_s"})) return {};
  return {here.required("vx_px_per_s").number(kSpeed).value_or(0.0),
          here.required("vy_px_per_s").number(kSpeed).value_or(0.0)};
}

Jitter read_jitter(const JsonPlace& here) {
  struct Rule {
    std::string_view kind;
    Jitter::Kind value;
    std::string_view amount_key;
    NumberRule amount;
  };
  static constexpr Rule kRules[] = {
      {"uniform", Jitter::Kind::uniform, "fraction", {0.0, 1.0}},
      {"normal", Jitter::Kind::normal, "sigma_s", {0.0, kFrameMax_s}},
      {"missed_frames", Jitter::Kind::missed_frames, "probability", {0.0, 1.0}}};
  Jitter jitter;
  if (here.json()->get<Json::Object>() == nullptr) {
    here.breaks_rule("must be an object");
    return jitter;
  }
  jitter.seed = here.required("seed").seed().value_or(0);
  const auto kind = here.required("kind").text();
  const auto rule =
      std::find_if(std::begin(kRules), std::end(kRules), [&](const Rule& r) { return kind == r.kind; });
  if (rule == std::end(kRules)) {
    if (kind) here.member("kind").breaks_rule("must be \"uniform\", \"normal\" or \"missed_frames\"");
    return jitter;
  }
  static_cast<void>(here.is_object_of({"kind", rule->amount_key, "seed"}));
  jitter.kind = rule->value;
  jitter.amount = here.required(rule->amount_key).number(rule->amount).value_or(0.0);
  return jitter;
}

RecordedSteps read_trace(const JsonPlace& here) {
  RecordedSteps trace;
  const auto frames = here.elements();
  if (frames && frames->empty()) here.wrong("must hold at least one dt, is []");
  if (frames)
    for (const JsonPlace& frame : *frames) trace.dt_s.push_back(frame.number(kFrame).value_or(0.0));
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
    clock.base = FixedStep{dt.number(kFrame).value_or(1.0)};
  const JsonPlace jitter = here.member("jitter");
  if (!jitter.is_there()) return;
  if (std::holds_alternative<RecordedSteps>(clock.base))
    jitter.wrong("cannot stand beside an array dt_s, which says every dt already");
  clock.jitter = read_jitter(jitter);
}

// The number of frames, where it can be told: of a duration only if the clock is good.
std::optional<std::int64_t> read_length(const JsonPlace& document, bool is_clock_good, Scenario& scenario) {
  const JsonPlace steps = document.member("steps");
  const JsonPlace duration = document.member("duration_s");
  const auto count = steps.integer(0, kStepsMax);
  const auto duration_s = duration.number(kNotNegative);
  if (count) scenario.length = *count;
  if (const auto* trace = std::get_if<RecordedSteps>(&scenario.clock.base)) {
    const auto frames = static_cast<std::int64_t>(trace->dt_s.size());
    if (duration.is_there()) duration.wrong("cannot stand beside an array dt_s, whose length says it");
    if (count && *count != frames)
      steps.breaks_rule("must be the length of the array dt_s, " + std::to_string(frames));
    return frames;
  }
  const bool is_one = steps.is_there() != duration.is_there();
  if (!is_one && (is_clock_good || steps.is_there()))
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

Resize read_resize(const JsonPlace& here) {
  Resize resize;
  if (!here.is_object_of({"window", "sprite"})) return resize;
  if (const JsonPlace window = here.member("window"); window.is_there()) resize.window = read_window(window);
  if (const JsonPlace sprite = here.member("sprite"); sprite.is_there()) resize.sprite = read_sprite(sprite);
  if (!resize.window && !resize.sprite) here.wrong("must hold window, sprite or both");
  return resize;
}

Action read_action(const JsonPlace& here, std::string_view key) {
  if (key == "fling") return Fling{read_velocity(here)};
  if (key == "release") return Release{read_velocity(here)};
  if (key == "resize") return read_resize(here);
  if (key == "place") return here.is_object_of({"x_px", "y_px"}) ? Place{read_position(here)} : Place{};
  if (key == "hitch")
    return Hitch{here.is_object_of({"dt_s"}) ? here.required("dt_s").number(kFrame).value_or(0.0) : 0.0};
  static_cast<void>(here.is_object_of({}));
  return key == "grab" ? Action(Grab{}) : Action(Stop{});
}

// An event, and how much of it could be read.
struct EventRead {
  Event event;
  bool has_time = false;
  bool has_action = false;  ///< Exactly one, and not a hitch of unknown length.
};

EventRead read_event(const JsonPlace& here, const std::vector<Problem>& problems) {
  static constexpr std::string_view kActions[] = {"fling", "place", "stop",   "resize",
                                                  "hitch", "grab",  "release"};
  EventRead read;
  if (!here.is_object_of({"step", "at_s", "fling", "place", "stop", "resize", "hitch", "grab", "release"}))
    return read;
  const auto step = here.member("step").integer(0, kStepsMax);
  const auto at_s = here.member("at_s").number();
  const bool is_one_time = here.member("step").is_there() != here.member("at_s").is_there();
  if (!is_one_time) here.wrong("must hold exactly one of step and at_s");
  if (step) read.event.when = *step;
  if (at_s) read.event.when = *at_s;
  read.has_time = is_one_time && (step || at_s);
  int actions = 0;
  bool is_bad_hitch = false;
  for (const std::string_view key : kActions) {
    const JsonPlace action = here.member(key);
    if (!action.is_there()) continue;
    const std::size_t problems_before = problems.size();
    read.event.action = read_action(action, key);
    is_bad_hitch |= key == "hitch" && problems.size() > problems_before;
    ++actions;
  }
  if (actions != 1)
    here.wrong("must hold exactly one action (fling, place, stop, resize, hitch, grab or release), holds " +
               std::to_string(actions));
  read.has_action = actions == 1 && !is_bad_hitch;
  return read;
}

// As far as every action is known.
void check_holds(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events) {
  bool is_held = false;
  for (std::size_t event = 0; event < events.size() && events[event].has_action; ++event) {
    const Action& action = events[event].event.action;
    if (std::holds_alternative<Grab>(action)) {
      if (is_held) places[event].wrong("grabs a sprite that is held already; release it first");
      is_held = true;
    }
    if (std::holds_alternative<Release>(action)) {
      if (!is_held) places[event].wrong("releases a sprite that is not held; grab it first");
      is_held = false;
    }
  }
}

void tell_fault(const JsonPlace& event, ScheduleFault fault, std::int64_t steps) {
  const bool has_step = event.member("step").is_there();
  const JsonPlace when = event.member(has_step ? "step" : "at_s");
  if (fault == ScheduleFault::goes_backwards)
    when.breaks_rule("must not come before the event above it");
  else if (has_step)
    when.breaks_rule("must be below the number of steps, " + std::to_string(steps));
  else
    when.breaks_rule("must come before the end of the run, step " + std::to_string(steps));
}

// What can be placed on a frame: an `at_s` only if the dt of every frame before it is known.
void check_times(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events,
                 bool is_clock_good, std::int64_t steps, Scenario scenario) {
  std::vector<JsonPlace> placed;
  scenario.events.clear();
  bool knows_times = is_clock_good;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const bool is_timed = std::holds_alternative<double>(events[event].event.when);
    if (events[event].has_time && (knows_times || !is_timed)) {
      placed.push_back(places[event]);
      scenario.events.push_back(events[event].event);
    }
    knows_times &= events[event].has_action;
  }
  for (const Schedule::Faulty& faulty : schedule_events(scenario, steps).faulty)
    tell_fault(placed[faulty.event], faulty.fault, steps);
}

std::optional<Interval> read_interval(const JsonPlace& here, const std::string& number_means,
                                      double low_of_number, bool number_is_exact) {
  if (!here.is_there()) return std::nullopt;
  if (here.json()->is_number()) {
    const double value = here.json()->number();
    return Interval{number_is_exact ? value : low_of_number, value};
  }
  const auto* array = here.json()->get<Json::Array>();
  if (array == nullptr || array->size() != 2 || !(*array)[0].is_number() || !(*array)[1].is_number() ||
      (*array)[0].number() > (*array)[1].number()) {
    here.breaks_rule("must be [low, high] with low <= high, or a number, " + number_means);
    return std::nullopt;
  }
  return Interval{(*array)[0].number(), (*array)[1].number()};
}

std::optional<Interval> read_bounds(const JsonPlace& here) {
  return read_interval(here, "the upper bound", -std::numeric_limits<double>::infinity(), false);
}

std::optional<Interval> read_count(const JsonPlace& here) {
  const auto interval = read_interval(here, "meant exactly", 0.0, true);
  const auto is_count = [](double value) {
    return value >= 0.0 && value == static_cast<double>(static_cast<std::int64_t>(value));
  };
  if (interval && (interval->high > 1e15 || !is_count(interval->low) || !is_count(interval->high)))
    here.breaks_rule("must count in whole numbers of 0 or more");
  return interval;
}

std::optional<std::string> read_hash(const JsonPlace& here) {
  const auto text = here.text();
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text && (text->size() != 32 || !std::all_of(text->begin(), text->end(), is_digit)))
    here.breaks_rule("must be 32 hex digits, 0-9 and a-f");
  return text;
}

Expect read_expect(const JsonPlace& here) {
  Expect expect;
  if (!here.is_object_of({"in_bounds", "finite", "final_x_px", "final_y_px", "at_rest_since_s", "contacts",
                          "state_hash", "implementation_px_max", "truncation_px_max",
                          "energy_drift_rel_max"}))
    return expect;
  expect.in_bounds = here.member("in_bounds").boolean();
  expect.finite = here.member("finite").boolean();
  expect.final_x_px = read_bounds(here.member("final_x_px"));
  expect.final_y_px = read_bounds(here.member("final_y_px"));
  expect.at_rest_since_s = read_bounds(here.member("at_rest_since_s"));
  if (const JsonPlace contacts = here.member("contacts");
      contacts.is_there() && contacts.is_object_of({"left", "right", "top", "ground"}))
    expect.contacts = {read_count(contacts.member("left")), read_count(contacts.member("right")),
                       read_count(contacts.member("top")), read_count(contacts.member("ground"))};
  expect.state_hash = read_hash(here.member("state_hash"));
  expect.implementation_px_max = here.member("implementation_px_max").number(kNotNegative);
  expect.truncation_px_max = here.member("truncation_px_max").number(kNotNegative);
  expect.energy_drift_rel_max = here.member("energy_drift_rel_max").number(kNotNegative);
  return expect;
}

void read_events(const JsonPlace& here, bool is_clock_good, std::optional<std::int64_t> steps,
                 Scenario& scenario, const std::vector<Problem>& problems) {
  const auto places = here.elements();
  if (!places) return;
  std::vector<EventRead> events;
  for (const JsonPlace& place : *places) events.push_back(read_event(place, problems));
  check_holds(*places, events);
  if (steps) check_times(*places, events, is_clock_good, *steps, scenario);
  for (EventRead& read : events) scenario.events.push_back(std::move(read.event));
}

void read_record(const JsonPlace& here, Scenario& scenario) {
  if (!here.is_there() || !here.is_object_of({"every"})) return;
  scenario.record_every = here.member("every").integer(1, kStepsMax).value_or(1);
}

Scenario read_document(const JsonPlace& document, const std::string& fallback_name,
                       const std::vector<Problem>& problems) {
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
  const std::size_t problems_before_clock = problems.size();
  read_clock(document.required("clock"), scenario.clock);
  const bool is_clock_good = problems.size() == problems_before_clock;
  const auto steps = read_length(document, is_clock_good, scenario);
  read_events(document.member("events"), is_clock_good, steps, scenario, problems);
  read_record(document.member("record"), scenario);
  if (const JsonPlace expect = document.member("expect"); expect.is_there())
    scenario.expect = read_expect(expect);
  return scenario;
}

// A value given as text: JSON where it is JSON, else the text itself.
Json value_of(const Override& given) {
  try {
    return parse_json(given.value, given.pointer);
  } catch (const Failure&) {
    return given.value;
  }
}

void put_over(Json& document, const Override& given, const std::string& path) {
  try {
    set_at(document, given.pointer, value_of(given));
  } catch (const Failure& failure) {
    throw Failure(failure.exit_code(), path + ": " + failure.what());
  }
}

}  // namespace

Scenario to_scenario(const Json& document, const std::string& source, const std::string& fallback_name) {
  std::vector<Problem> problems;
  Scenario scenario = read_document(JsonPlace(&document, "", problems), fallback_name, problems);
  if (problems.empty()) return scenario;
  std::string sentences;
  for (const Problem& problem : problems)
    sentences += (sentences.empty() ? "" : "\n") + source + ": " +
                 (problem.pointer.empty() ? "/" : problem.pointer) + ": " + problem.sentence;
  throw Failure(ExitCode::bad_input, sentences);
}

Scenario load_scenario(const std::string& path, const std::vector<Override>& overrides) {
  Json document = parse_json(read_text_file(path), path);
  for (const Override& given : overrides) put_over(document, given, path);
  return to_scenario(document, path, std::filesystem::path(path).stem().string());
}

Scenario parse_scenario(std::string_view text, const std::string& source) {
  return to_scenario(parse_json(text, source), source, "");
}

}  // namespace hyrax

#include "tools/files/scenario_head.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/numbers.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

using Object = Json::Object;

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

Jitter read_jitter(const JsonPlace& here) {
  if (here.json()->get<Json::Object>() == nullptr) {
    here.breaks_rule("must be an object");
    return {};
  }
  const auto seed = here.required("seed").seed();
  const auto kind = here.required("kind").text();
  const auto keys =
      std::ranges::find_if(kJitterKeys, [&](const JitterKeys& each) { return kind == each.kind; });
  if (keys == kJitterKeys.end()) {
    std::vector<std::string_view> kinds;
    for (const JitterKeys& each : kJitterKeys) kinds.push_back(each.kind);
    if (kind) here.member("kind").wrong(unknown_word("value", *kind, kinds));
    // The keys of all kinds are allowed, each with its own rule.
    static_cast<void>(here.is_object_of({"kind", "fraction", "sigma_s", "probability", "seed"}));
    for (const JitterKeys& each : kJitterKeys)
      static_cast<void>(here.member(each.amount).number({0.0, each.amount_max}));
    return {};
  }
  static_cast<void>(here.is_object_of({"kind", keys->amount, "seed"}));
  return {static_cast<Jitter::Kind>(keys - kJitterKeys.begin()),
          here.required(keys->amount).number({0.0, keys->amount_max}).value_or(0.0), seed.value_or(0)};
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
  clock.jitter = read_jitter(jitter);
  if (!std::holds_alternative<RecordedSteps>(clock.base)) return;
  jitter.wrong("not allowed with an array dt_s, which gives every dt");
  clock.jitter.reset();  // The events are checked against the trace alone.
}

// The number of frames if it is known: of a duration only if the clock is valid.
std::optional<std::int64_t> read_length(const JsonPlace& document, bool is_clock_good,
                                        ScenarioHead& scenario) {
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

Json to_json(const Jitter& jitter) {
  const JitterKeys& keys = kJitterKeys.at(static_cast<std::size_t>(jitter.kind));
  return Object{{"kind", keys.kind}, {std::string(keys.amount), jitter.amount}, {"seed", jitter.seed}};
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

}  // namespace

bool is_of_other_core(const JsonPlace& document, std::string_view own_core) {
  const JsonPlace here = document.member("core");
  const auto* const core = here.is_there() ? here.json()->get<std::string>() : nullptr;
  if (core == nullptr || *core == own_core) return false;
  here.wrong("is a scenario of the core " + *core + ": play it with " + *core + "-sim");
  return true;
}

void read_names(const JsonPlace& document, const std::string& fallback_name, ScenarioHead& head) {
  head.schema = document.member("$schema").text();
  read_format(document.required("format"));
  head.name = read_name(document.member("name"), fallback_name);
  head.description = document.member("description").text();
}

FramesRead read_frames(const JsonPlace& document, ScenarioHead& head) {
  const std::size_t problems_before_clock = document.problem_count();
  read_clock(document.required("clock"), head.clock);
  const bool is_clock_good = document.problem_count() == problems_before_clock;
  return {is_clock_good, read_length(document, is_clock_good, head)};
}

void read_record(const JsonPlace& document, ScenarioHead& head) {
  const JsonPlace here = document.member("record");
  if (!here.is_there() || !here.is_object_of({"every"})) return;
  head.record_every = here.member("every").positive_integer(kStepsMax).value_or(1);
}

std::optional<Interval> read_interval(const JsonPlace& here, const std::string& or_a_number) {
  if (!here.is_there()) return std::nullopt;
  const auto* array = here.json()->get<Json::Array>();
  if (array == nullptr || array->size() != 2 || !(*array)[0].is_number() || !(*array)[1].is_number() ||
      (*array)[0].number() > (*array)[1].number())
    return here.breaks_rule("must be [low, high] with low <= high" + or_a_number);
  const auto low = here.element(0).number();
  const auto high = here.element(1).number();
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

std::optional<Interval> read_time(const JsonPlace& here) {
  if (!here.is_there() || !here.json()->is_number())
    return read_interval(here, ", or a number as upper bound");
  const auto latest = here.number();
  return latest ? std::optional(Interval{-std::numeric_limits<double>::infinity(), *latest}) : std::nullopt;
}

std::optional<Interval> read_count(const JsonPlace& here) {
  const bool is_exact = here.is_there() && here.json()->is_number();
  const auto interval = is_exact ? std::optional(Interval{here.json()->number(), here.json()->number()})
                                 : read_interval(here, ", or an exact number");
  const auto is_count = [](const Json& json) {
    return json.is_whole() && json.number() >= 0.0 && json.number() <= 1e15;
  };
  if (interval &&
      !(is_exact ? is_count(*here.json()) : std::ranges::all_of(*here.json()->get<Json::Array>(), is_count)))
    here.breaks_rule("must be whole numbers 0 .. 1e15");
  return interval;
}

std::optional<std::string> read_hash(const JsonPlace& here) {
  const auto text = here.text();
  if (text && (text->size() != 32 || text->find_first_not_of("0123456789abcdef") != std::string::npos))
    here.breaks_rule("must be 32 hex digits, 0-9 and a-f");
  return text;
}

void add_names(const ScenarioHead& head, Object& document) {
  add_member(document, "$schema", head.schema);
  document.emplace_back("format", kScenarioFormat);
  document.emplace_back("name", head.name);
  add_member(document, "description", head.description);
}

void add_frames(const ScenarioHead& head, Object& document) {
  document.emplace_back("clock", to_json(head.clock));
  if (const auto* steps = std::get_if<std::int64_t>(&head.length)) document.emplace_back("steps", *steps);
  if (const auto* duration_s = std::get_if<double>(&head.length))
    document.emplace_back("duration_s", *duration_s);
}

void add_record(const ScenarioHead& head, Object& document) {
  if (head.record_every != 1) document.emplace_back("record", Object{{"every", head.record_every}});
}

Object event_time_json(const std::variant<std::int64_t, double>& when) {
  if (const auto* step = std::get_if<std::int64_t>(&when)) return {{"step", *step}};
  return {{"at_s", std::get<double>(when)}};
}

Json interval_json(const Interval& interval) { return Json::Array{interval.low, interval.high}; }

// [v, v] must not become the number v, which means "at the latest".
Json time_json(const Interval& interval) {
  return std::isinf(interval.low) ? Json(interval.high) : interval_json(interval);
}

Json count_json(const Interval& interval) {
  return interval.low == interval.high ? Json(interval.high) : interval_json(interval);
}

}  // namespace hyrax

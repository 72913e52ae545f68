#include "tools/files/scenario_members.h"

#include <algorithm>

#include "sim/scenario/numbers.h"
#include "sim/scenario/schedule.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

Size read_size(const JsonPlace& here, std::int64_t low_px, std::int64_t high_px) {
  if (!here.is_object_of({"width_px", "height_px"})) return {};
  return {static_cast<std::int32_t>(here.required("width_px").integer(low_px, high_px).value_or(0)),
          static_cast<std::int32_t>(here.required("height_px").integer(low_px, high_px).value_or(0))};
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// [low, high]; a number alone is read by the caller.
std::optional<Interval> read_interval(const JsonPlace& here, const std::string& or_a_number = "") {
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
  return latest ? std::optional(Interval{-kInfinity, *latest}) : std::nullopt;
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

Resize read_resize(const JsonPlace& here) {
  Resize resize;
  if (!here.is_object_of({"window", "sprite"})) return resize;
  if (const JsonPlace window = here.member("window"); window.is_there()) resize.window = read_window(window);
  if (const JsonPlace sprite = here.member("sprite"); sprite.is_there()) resize.sprite = read_sprite(sprite);
  if (!resize.window && !resize.sprite) here.wrong("must hold window, sprite or both");
  return resize;
}

Action read_action(const JsonPlace& here, std::size_t kind) {
  Action action = make_action(kind);
  if (auto* const resize = std::get_if<Resize>(&action)) {
    *resize = read_resize(here);
    return action;
  }
  std::vector<std::string_view> keys;
  visit_numbers(action, [&](std::string_view key, const NumberField&) { keys.push_back(key); });
  if (!here.is_object_of(keys)) return action;
  visit_numbers(action, [&](std::string_view key, const NumberField& field) {
    field.set(here.required(key).number({field.low, field.high}).value_or(0.0));
  });
  return action;
}

constexpr std::size_t kHitchKind = Action(Hitch{}).index();

// An event, and how much of it could be read.
struct EventRead {
  Event event;
  bool has_time = false;
  bool has_action = false;      ///< Exactly one.
  bool has_known_time = false;  ///< And not a hitch of unknown length.
};

EventRead read_event(const JsonPlace& here) {
  EventRead read;
  std::vector<std::string_view> keys = {"step", "at_s"};
  keys.insert(keys.end(), kActionNames.begin(), kActionNames.end());
  if (!here.is_object_of(keys)) return read;
  const auto step = here.member("step").integer(0, kStepsMax);
  const auto at_s = here.member("at_s").number();
  const bool is_one_time = here.member("step").is_there() != here.member("at_s").is_there();
  if (!is_one_time) here.wrong("must hold exactly one of step and at_s");
  if (step) read.event.when = *step;
  if (at_s) read.event.when = *at_s;
  read.has_time = is_one_time && (step || at_s);
  int actions = 0;
  bool is_bad_hitch = false;
  for (std::size_t kind = 0; kind < kActionNames.size(); ++kind) {
    const JsonPlace action = here.member(kActionNames[kind]);
    if (!action.is_there()) continue;
    const std::size_t problems_before = here.problem_count();
    read.event.action = read_action(action, kind);
    is_bad_hitch |= kind == kHitchKind && here.problem_count() > problems_before;
    ++actions;
  }
  if (actions != 1)
    here.wrong("must hold exactly one action (found " + std::to_string(actions) +
               "); allowed: " + listed(kActionNames));
  read.has_action = actions == 1;
  read.has_known_time = read.has_action && !is_bad_hitch;
  return read;
}

// After an event of unknown action it is unknown whether the sprite is held, until the next grab or release.
void check_holds(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events) {
  enum class Hold { none, held, unknown } hold = Hold::none;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const Action& action = events[event].event.action;
    if (!events[event].has_action) {
      hold = Hold::unknown;
    } else if (std::holds_alternative<Grab>(action)) {
      if (hold == Hold::held) places[event].wrong("the sprite is held already; release it first");
      hold = Hold::held;
    } else if (std::holds_alternative<Release>(action)) {
      if (hold == Hold::none) places[event].wrong("the sprite is not held; grab it first");
      hold = Hold::none;
    }
  }
}

void add_fault(const JsonPlace& event, ScheduleFault fault, std::int64_t steps) {
  const bool has_step = event.member("step").is_there();
  const JsonPlace when = event.member(has_step ? "step" : "at_s");
  if (fault == ScheduleFault::goes_backwards)
    when.breaks_rule("must not be before the previous event");
  else if (fault == ScheduleFault::too_far)
    when.breaks_rule("must fall on a frame up to " + std::to_string(kWalkedFrameMax) +
                     " where the clock has jitter (give step instead)");
  else if (has_step)
    when.breaks_rule("must be below the number of steps, " + std::to_string(steps));
  else
    when.breaks_rule("must come before the end of the run, step " + std::to_string(steps));
}

// An `at_s` has a frame only if the dt of every frame before it is known. Of a run of unknown length only the
// order is checked.
void check_times(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events,
                 bool is_clock_good, std::optional<std::int64_t> steps, Scenario scenario) {
  std::vector<JsonPlace> placed;
  scenario.events.clear();
  bool knows_times = is_clock_good;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const bool is_timed = std::holds_alternative<double>(events[event].event.when);
    if (events[event].has_time && (knows_times || !is_timed)) {
      placed.push_back(places[event]);
      scenario.events.push_back(events[event].event);
    }
    knows_times &= events[event].has_known_time;
  }
  const std::int64_t end = steps.value_or(kStepsMax + 1);
  for (const Schedule::Faulty& faulty : schedule_events(scenario, end).faulty)
    if (steps || faulty.fault == ScheduleFault::goes_backwards)
      add_fault(placed[faulty.event], faulty.fault, end);
}

}  // namespace

Size read_window(const JsonPlace& here) { return read_size(here, 0, kWindowSideMax_px); }
Size read_sprite(const JsonPlace& here) { return read_size(here, kSpriteSideMin_px, kSpriteSideMax_px); }

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

void read_events(const JsonPlace& here, bool is_clock_good, std::optional<std::int64_t> steps,
                 Scenario& scenario) {
  const Json::Array* array = here.array();
  if (array == nullptr) return;
  std::vector<JsonPlace> places;
  std::vector<EventRead> events;
  for (std::size_t event = 0; event < array->size(); ++event) {
    places.push_back(here.element(event));
    events.push_back(read_event(places.back()));
  }
  check_holds(places, events);
  check_times(places, events, is_clock_good, steps, scenario);
  for (EventRead& read : events) scenario.events.push_back(std::move(read.event));
}

}  // namespace hyrax

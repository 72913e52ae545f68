#include "tools/files/event_reader.h"

#include "sim/scenario/schedule.h"
#include "tools/files/quantity_reader.h"

namespace hyrax {
namespace {

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
    return Hitch{here.is_object_of({"dt_s"}) ? here.required("dt_s").number(kFrameRule).value_or(0.0) : 0.0};
  static_cast<void>(here.is_object_of({}));
  return key == "grab" ? Action(Grab{}) : Action(Stop{});
}

// An event, and how much of it could be read.
struct EventRead {
  Event event;
  bool has_time = false;
  bool has_action = false;      ///< Exactly one.
  bool has_known_time = false;  ///< And not a hitch of unknown length.
};

EventRead read_event(const JsonPlace& here, const JsonProblems& problems) {
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
  for (const std::string_view key : kActionNames) {
    const JsonPlace action = here.member(key);
    if (!action.is_there()) continue;
    const std::size_t problems_before = problems.count;
    read.event.action = read_action(action, key);
    is_bad_hitch |= key == "hitch" && problems.count > problems_before;
    ++actions;
  }
  if (actions != 1)
    here.wrong("must hold exactly one action (fling, place, stop, resize, hitch, grab or release), holds " +
               std::to_string(actions));
  read.has_action = actions == 1;
  read.has_known_time = read.has_action && !is_bad_hitch;
  return read;
}

// After an event whose action is not known, nothing is known of the hold until the next grab or release.
void check_holds(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events) {
  enum class Hold { none, held, unknown } hold = Hold::none;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const Action& action = events[event].event.action;
    if (!events[event].has_action) {
      hold = Hold::unknown;
    } else if (std::holds_alternative<Grab>(action)) {
      if (hold == Hold::held) places[event].wrong("grabs a sprite that is held already; release it first");
      hold = Hold::held;
    } else if (std::holds_alternative<Release>(action)) {
      if (hold == Hold::none) places[event].wrong("releases a sprite that is not held; grab it first");
      hold = Hold::none;
    }
  }
}

void tell_fault(const JsonPlace& event, ScheduleFault fault, std::int64_t steps) {
  const bool has_step = event.member("step").is_there();
  const JsonPlace when = event.member(has_step ? "step" : "at_s");
  if (fault == ScheduleFault::goes_backwards)
    when.breaks_rule("must not come before the event above it");
  else if (fault == ScheduleFault::too_far)
    when.breaks_rule("must fall on a frame up to " + std::to_string(kWalkedFrameMax) +
                     " where the clock has jitter (give step instead)");
  else if (has_step)
    when.breaks_rule("must be below the number of steps, " + std::to_string(steps));
  else
    when.breaks_rule("must come before the end of the run, step " + std::to_string(steps));
}

// What can be placed on a frame: an `at_s` only if the dt of every frame before it is known. Of a run of
// unknown length the order alone can be checked.
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
      tell_fault(placed[faulty.event], faulty.fault, end);
}

}  // namespace

void read_events(const JsonPlace& here, bool is_clock_good, std::optional<std::int64_t> steps,
                 Scenario& scenario, const JsonProblems& problems) {
  const Json::Array* array = here.array();
  if (array == nullptr) return;
  std::vector<JsonPlace> places;
  std::vector<EventRead> events;
  for (std::size_t event = 0; event < array->size(); ++event) {
    places.push_back(here.element(event));
    events.push_back(read_event(places.back(), problems));
  }
  check_holds(places, events);
  check_times(places, events, is_clock_good, steps, scenario);
  for (EventRead& read : events) scenario.events.push_back(std::move(read.event));
}

}  // namespace hyrax

#include "tools/files/event_reader.h"

#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

using Hold = EventEffect::Hold;

// An event, and how much of it could be read.
struct EventRead {
  EventTime time = {};
  Hold hold = Hold::unchanged;
  bool has_time = false;
  bool has_action = false;      ///< Exactly one.
  bool has_known_time = false;  ///< And not a hitch of unknown length.
};

EventRead read_event(const JsonPlace& here, std::size_t event, const ActionRules& rules) {
  EventRead read;
  std::vector<std::string_view> keys = {"step", "at_s"};
  keys.insert(keys.end(), rules.names.begin(), rules.names.end());
  if (!here.is_object_of(keys)) return read;
  const auto step = here.member("step").integer(0, kStepsMax);
  const auto at_s = here.member("at_s").number();
  const bool is_one_time = here.member("step").is_there() != here.member("at_s").is_there();
  if (!is_one_time) here.wrong("must hold exactly one of step and at_s");
  if (step) read.time.when = *step;
  if (at_s) read.time.when = *at_s;
  read.has_time = is_one_time && (step || at_s);
  int actions = 0;
  bool is_bad_hitch = false;
  for (std::size_t number = 0; number < rules.names.size(); ++number) {
    const JsonPlace action = here.member(rules.names[number]);
    if (!action.is_there()) continue;
    const std::size_t problems_before = here.problem_count();
    const EventEffect effect = rules.read(action, event, number);
    read.hold = effect.hold;
    read.time.hitch_dt_s = effect.hitch_dt_s;
    is_bad_hitch |= effect.hitch_dt_s && here.problem_count() > problems_before;
    ++actions;
  }
  if (actions != 1)
    here.wrong("must hold exactly one action (found " + std::to_string(actions) +
               "); allowed: " + listed(rules.names));
  read.has_action = actions == 1;
  read.has_known_time = read.has_action && !is_bad_hitch;
  return read;
}

// After an event of unknown action it is unknown whether frames are held, until the next hold or its end.
void check_holds(const std::vector<JsonPlace>& places, const std::vector<EventRead>& events,
                 const ActionRules& rules) {
  Hold now = Hold::let_go;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const Hold next = events[event].has_action ? events[event].hold : Hold::unchanged;
    if (!events[event].has_action) now = Hold::unchanged;
    if (next == Hold::unchanged) continue;
    if (next == now) places[event].wrong(next == Hold::held ? rules.held_already : rules.not_held);
    now = next;
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
                 const FramesRead& frames, const Clock& clock) {
  std::vector<JsonPlace> placed;
  std::vector<EventTime> times;
  bool knows_times = frames.is_clock_good;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const bool is_timed = std::holds_alternative<double>(events[event].time.when);
    if (events[event].has_time && (knows_times || !is_timed)) {
      placed.push_back(places[event]);
      times.push_back(events[event].time);
    }
    knows_times &= events[event].has_known_time;
  }
  const std::int64_t end = frames.steps.value_or(kStepsMax + 1);
  for (const Schedule::Faulty& faulty : schedule_events(clock, times, end).faulty)
    if (frames.steps || faulty.fault == ScheduleFault::goes_backwards)
      add_fault(placed[faulty.event], faulty.fault, end);
}

}  // namespace

std::vector<EventTime> read_events(const JsonPlace& here, const FramesRead& frames, const Clock& clock,
                                   const ActionRules& rules) {
  const Json::Array* array = here.array();
  if (array == nullptr) return {};
  std::vector<JsonPlace> places;
  std::vector<EventRead> events;
  for (std::size_t event = 0; event < array->size(); ++event) {
    places.push_back(here.element(event));
    events.push_back(read_event(places.back(), event, rules));
  }
  check_holds(places, events, rules);
  check_times(places, events, frames, clock);
  std::vector<EventTime> times;
  times.reserve(events.size());
  for (const EventRead& event : events) times.push_back(event.time);
  return times;
}

}  // namespace hyrax

#include "sim/search/scenario_edit.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <string_view>

#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

std::int64_t frame_of(const Event& event) { return std::get<std::int64_t>(event.when); }

// Of the events that are left, a release without its grab becomes the fling that it also is, and a grab while
// held goes.
std::vector<Event> paired(const std::vector<Event>& events) {
  bool is_held = false;
  std::vector<Event> paired;
  for (Event event : events) {
    const auto* const release = std::get_if<Release>(&event.action);
    const bool is_grab = std::holds_alternative<Grab>(event.action);
    if (is_grab && is_held) continue;
    if (release != nullptr && !is_held) event.action = Fling{release->velocity};
    is_held = is_grab || (is_held && release == nullptr);
    paired.push_back(event);
  }
  return paired;
}

// In order, before the end, each `grab` while not held and each `release` while held.
bool are_good(const std::vector<Event>& events, std::int64_t steps) {
  if (!std::ranges::is_sorted(events, {}, frame_of) || paired(events) != events) return false;
  if (!events.empty() && (frame_of(events.front()) < 0 || frame_of(events.back()) >= steps)) return false;
  return std::ranges::none_of(events, [](const Event& event) { return event.action == Action(Resize()); });
}

}  // namespace

Scenario plain(const Scenario& scenario) {
  Scenario plain = scenario;
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  for (std::size_t event = 0; event < frames.size(); ++event) plain.events[event].when = frames[event];
  plain.length = std::monostate{};
  if (!std::holds_alternative<RecordedSteps>(plain.clock.base)) plain.length = steps;
  plain.schema.reset();  // A path from another folder.
  return plain;
}

Scenario without_frames(const Scenario& scenario, std::int64_t first, std::int64_t last) {
  assert(0 <= first && first <= last && last <= step_count(scenario));
  Scenario shorter = scenario;
  if (auto* const trace = std::get_if<RecordedSteps>(&shorter.clock.base))
    trace->dt_s.erase(trace->dt_s.begin() + first, trace->dt_s.begin() + last);
  else
    shorter.length = step_count(scenario) - (last - first);
  std::erase_if(shorter.events,
                [&](const Event& event) { return frame_of(event) >= first && frame_of(event) < last; });
  for (Event& event : shorter.events)
    if (frame_of(event) >= last) event.when = frame_of(event) - (last - first);
  shorter.events = paired(shorter.events);
  return shorter;
}

Scenario without_events(const Scenario& scenario, std::size_t first, std::size_t last) {
  assert(first <= last && last <= scenario.events.size());
  Scenario simpler = scenario;
  simpler.events.erase(simpler.events.begin() + static_cast<std::ptrdiff_t>(first),
                       simpler.events.begin() + static_cast<std::ptrdiff_t>(last));
  simpler.events = paired(simpler.events);
  return simpler;
}

Scenario after_frames(const Core& core, const Scenario& scenario, std::int64_t frames) {
  assert(0 <= frames && frames <= step_count(scenario));
  Replay run(with_parameters(core, scenario.parameters).value(), scenario);
  run.play_to(frames);
  const Keyframe& then = run.keyframe();
  Scenario later = without_frames(scenario, 0, frames);
  later.window = then.window;
  later.sprite = then.sprite;
  later.start = {then.row.x_px, then.row.y_px};
  later.start_velocity = {then.row.vx_px_per_s, then.row.vy_px_per_s};
  if (!then.is_held) return later;
  later.events = scenario.events;  // With the grab before the cut, so that its release stays one.
  std::erase_if(later.events, [&](const Event& event) { return frame_of(event) < frames; });
  for (Event& event : later.events) event.when = frame_of(event) - frames;
  if (step_count(later) > 0) later.events.insert(later.events.begin(), {std::int64_t{0}, Grab{}});
  return later;
}

Scenario recorded(const Scenario& scenario) {
  const std::int64_t steps = step_count(scenario);
  assert(steps > 0);
  const FrameClock clock(scenario.clock);
  RecordedSteps trace;
  for (std::int64_t frame = 0; frame < steps; ++frame) trace.dt_s.push_back(clock.dt_s(frame));
  Scenario same = scenario;
  for (const Event& event : scenario.events)
    if (const auto* const hitch = std::get_if<Hitch>(&event.action))
      trace.dt_s[static_cast<std::size_t>(frame_of(event))] = hitch->dt_s;
  std::erase_if(same.events, [](const Event& event) { return std::holds_alternative<Hitch>(event.action); });
  same.clock = {.base = std::move(trace), .jitter = {}};
  same.length = std::monostate{};
  return same;
}

bool is_valid(const Scenario& scenario) {
  Scenario copy = scenario;
  const std::vector<NumberField> numbers = numbers_of(copy);
  const auto* const trace = std::get_if<RecordedSteps>(&scenario.clock.base);
  return std::all_of(numbers.begin(), numbers.end(),
                     [](const NumberField& number) { return number.allows(number.value()); }) &&
         (trace == nullptr || !trace->dt_s.empty()) && step_count(scenario) >= 0 &&
         step_count(scenario) <= kStepsMax && are_good(scenario.events, step_count(scenario));
}
namespace {

// The significant digits of a decimal text: those of its mantissa, without zeros at either end.
std::int64_t significant_digits(std::string_view text) {
  std::string mantissa(text.substr(0, text.find('e')));
  std::erase_if(mantissa, [](char letter) { return letter < '0' || letter > '9'; });
  const std::size_t first = mantissa.find_first_not_of('0');
  return first == std::string::npos ? 0
                                    : static_cast<std::int64_t>(mantissa.find_last_not_of('0') - first + 1);
}

template <class Value>
std::int64_t digits_in(const Value& value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return significant_digits({text, static_cast<std::size_t>(end.ptr - text)});
}

void round_value(double& value, int digits) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
  std::from_chars(text, end.ptr, value);
}

template <class Whole>
void round_value(Whole& value, int digits) {
  Whole unit = 1;
  for (Whole rest = value; rest != 0; rest /= 10)
    if (--digits < 0) unit *= 10;
  value = value / unit * unit;
}

}  // namespace

std::int64_t digits_of(const Scenario& scenario) {
  Scenario copy = scenario;
  std::int64_t digits = 0;
  for (const NumberField& number : numbers_of(copy))
    digits += std::visit([](const auto* value) { return digits_in(*value); }, number.at);
  return digits;
}

void round_to(const NumberField& number, int digits) {
  std::visit(
      [digits](auto* value) {
        if (digits == 0)
          *value = 0;
        else
          round_value(*value, digits);
      },
      number.at);
}

}  // namespace hyrax

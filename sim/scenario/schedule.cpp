#include "sim/scenario/schedule.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-9;  // Of a dt, so that at_s = 2.0 at 60 Hz means frame 120.

bool is_due(double start_s, double at_s, double dt_s) { return start_s >= at_s - kTolerance * dt_s; }

// The latest at_s for which a frame that starts at `start_s` is due: the sum, within its rounding.
double latest_due_s(double start_s, double dt_s) {
  double at_s = start_s + kTolerance * dt_s;
  while (!is_due(start_s, at_s, dt_s)) at_s = std::nextafter(at_s, -kInfinity);
  while (is_due(start_s, std::nextafter(at_s, kInfinity), dt_s)) at_s = std::nextafter(at_s, kInfinity);
  return at_s;
}

// Walks the start times of frames forwards, events in order.
class Walk {
 public:
  Walk(const Clock& clock, std::int64_t steps, std::int64_t walked_frame_max)
      : clock_(clock),
        is_jittered_(clock.jitter.has_value()),
        steps_(steps),
        walked_frame_max_(walked_frame_max) {
    if (is_jittered_) longest_dt_s_ = longest_dt_s(clock);
  }

  std::int64_t frame() const { return frame_; }

  void play_to(std::int64_t frame) {
    if (is_jittered_ && frame > walked_frame_max_) return jump_to(frame);
    while (frame_ < frame) play(is_even() ? frame - frame_ : 1);
  }

  // Goes on to a frame behind which no time is asked for, or is too far to be found.
  void jump_to(std::int64_t frame) { frame_ = frame; }

  // Goes on to the first frame that starts at `at_s` or later.
  std::optional<ScheduleFault> play_to_time(double at_s) {
    if (has_passed(at_s)) return ScheduleFault::goes_backwards;
    const std::int64_t last = is_jittered_ ? std::min(walked_frame_max_, steps_) : steps_;
    if (frame_ > last) return ScheduleFault::too_far;  // Jumped there: its time is unknown.
    if (at_s > reach_s_ || is_out_of_reach(at_s, steps_)) return ScheduleFault::beyond_end;
    if (is_out_of_reach(at_s, last)) return ScheduleFault::too_far;
    while (frame_ < steps_ && !is_due(timeline_.time_s(), at_s, clock_.nominal_dt_s(frame_))) {
      if (frame_ == last) return ScheduleFault::too_far;
      play(is_even() ? even_frames_to(at_s) : 1);
    }
    if (frame_ == steps_) return ScheduleFault::beyond_end;
    return std::nullopt;
  }

  // Whether searches in vain have walked so far that there must be no more of them.
  bool is_tired() const { return walked_in_vain_ >= walked_frame_max_; }

  void hitch(double dt_s) {
    hitch_dt_s_ = dt_s;
    reach_s_ = kInfinity;
  }

  // Back to `before`. A walk that came to the end learned the latest time that has a frame, so that
  // many events beyond it do not make as many walks.
  void go_back(const Walk& before) {
    const double reach_s = frame_ == steps_ ? passed_s() : reach_s_;
    const std::int64_t in_vain = clock_.is_fixed() ? 0 : frame_ - before.frame_;
    const std::int64_t walked_in_vain = walked_in_vain_ + in_vain;
    *this = before;
    reach_s_ = reach_s;
    walked_in_vain_ = walked_in_vain;
  }

 private:
  bool is_even() const { return clock_.is_fixed() && !hitch_dt_s_; }

  // Whether a frame that is behind starts at `at_s` or later already.
  bool has_passed(double at_s) const {
    return at_s <= passed_s_ || is_due(latest_start_s_, at_s, latest_nominal_dt_s_);
  }

  // Whether no frame up to `last` can start at `at_s` or later, however long jitter makes those to come;
  // with room for the rounding of their sum.
  bool is_out_of_reach(double at_s, std::int64_t last) const {
    const double frames_s = static_cast<double>(last - frame_) * longest_dt_s_;
    const double latest_s = timeline_.time_s() + hitch_dt_s_.value_or(0.0) + frames_s;
    return at_s > latest_s * (1.0 + 1e-9) + kTolerance * longest_dt_s_;
  }

  void play(std::int64_t count) {
    const double dt_s = hitch_dt_s_.value_or(clock_.dt_s(frame_));
    const double nominal_dt_s = clock_.nominal_dt_s(frame_);
    hitch_dt_s_.reset();
    pass(timeline_.time_s(), nominal_dt_s);
    timeline_.play(dt_s, count);
    if (count > 1) pass(timeline_.time_s(-1), nominal_dt_s);
    frame_ += count;
  }

  // Among frames of one nominal dt, the latest start decides.
  void pass(double start_s, double nominal_dt_s) {
    if (nominal_dt_s != latest_nominal_dt_s_) {
      passed_s_ = passed_s();
      latest_start_s_ = -kInfinity;
      latest_nominal_dt_s_ = nominal_dt_s;
    }
    latest_start_s_ = std::max(latest_start_s_, start_s);
  }

  // The latest at_s that a frame behind is due for.
  double passed_s() const {
    if (latest_start_s_ == -kInfinity) return passed_s_;
    return std::max(passed_s_, latest_due_s(latest_start_s_, latest_nominal_dt_s_));
  }

  // Frames of the clock's fixed dt until one starts at `at_s` or later, or all that are left: by
  // bisection, as start times do not fall and far from zero many of them are equal.
  std::int64_t even_frames_to(double at_s) const {
    const double dt_s = clock_.dt_s(frame_);
    Timeline ahead = timeline_;
    ahead.play(dt_s, 0);
    std::int64_t early = 0;
    std::int64_t late = steps_ - frame_;
    while (late - early > 1) {
      const std::int64_t middle = early + (late - early) / 2;
      (is_due(ahead.time_s(middle), at_s, dt_s) ? late : early) = middle;
    }
    return late;
  }

  FrameClock clock_;
  bool is_jittered_;
  double longest_dt_s_ = kInfinity;  // Of a jittered clock; on others a search needs no bound.
  std::int64_t steps_;
  std::int64_t walked_frame_max_;
  std::int64_t frame_ = 0;
  Timeline timeline_;
  std::optional<double> hitch_dt_s_;
  double passed_s_ = -kInfinity;  // As passed_s(), of frames whose nominal dt differs from the latest's.
  double latest_start_s_ = -kInfinity;
  double latest_nominal_dt_s_ = 0.0;
  double reach_s_ = kInfinity;  // The latest at_s that any frame is due for, as far as it is known.
  std::int64_t walked_in_vain_ = 0;
};

// Goes to the event's frame; where no later event has a time, without walking there.
std::optional<ScheduleFault> go_to(Walk& walk, const EventTime& event, std::int64_t steps,
                                   bool is_time_needed) {
  if (const auto* at_s = std::get_if<double>(&event.when)) return walk.play_to_time(*at_s);
  const std::int64_t step = std::get<std::int64_t>(event.when);
  if (step >= steps) return ScheduleFault::beyond_end;
  if (step < walk.frame()) return ScheduleFault::goes_backwards;
  is_time_needed ? walk.play_to(step) : walk.jump_to(step);
  return std::nullopt;
}

// One past the last event that has a time.
std::size_t timed_end(const std::vector<EventTime>& events) {
  std::size_t end = events.size();
  while (end > 0 && !std::holds_alternative<double>(events[end - 1].when)) --end;
  return end;
}

}  // namespace

Schedule schedule_events(const Clock& clock, const std::vector<EventTime>& events, std::int64_t steps,
                         std::int64_t walked_frame_max) {
  assert(walked_frame_max > 0);
  Schedule schedule;
  Walk walk(clock, steps, walked_frame_max);
  const std::size_t last_timed = timed_end(events);
  for (const EventTime& event : events) {
    const std::size_t number = schedule.frames.size();
    if (walk.is_tired() && std::holds_alternative<double>(event.when)) {
      schedule.frames.push_back(-1);
      continue;
    }
    const Walk before = walk;
    if (const auto fault = go_to(walk, event, steps, number < last_timed)) {
      schedule.faulty.push_back({number, *fault});
      schedule.frames.push_back(-1);
      walk.go_back(before);  // So that the next event is not judged by one that has no frame.
      continue;
    }
    schedule.frames.push_back(walk.frame());
    if (event.hitch_dt_s) walk.hitch(*event.hitch_dt_s);
  }
  return schedule;
}

Schedule schedule_events(const Scenario& scenario, std::int64_t steps, std::int64_t walked_frame_max) {
  std::vector<EventTime> events;
  events.reserve(scenario.events.size());
  for (const Event& event : scenario.events) {
    const auto* const hitch = std::get_if<Hitch>(&event.action);
    events.push_back({event.when, hitch == nullptr ? std::nullopt : std::optional(hitch->dt_s)});
  }
  return schedule_events(scenario.clock, events, steps, walked_frame_max);
}

bool same_bits(const Input& a, const Input& b) {
  const auto bits_of = [](Action action) {
    // With paths: a resize may have one size. None has more numbers than that of both.
    std::array<std::pair<std::string_view, std::uint64_t>, 4> bits;
    std::size_t count = 0;
    visit_numbers(action, [&](std::string_view path, const NumberField& field) {
      bits.at(count++) = {path, std::bit_cast<std::uint64_t>(field.value())};
    });
    return bits;
  };
  return a.frame == b.frame && a.action.index() == b.action.index() && bits_of(a.action) == bits_of(b.action);
}

std::vector<Input> inputs_of(const Scenario& scenario, std::int64_t frames) {
  const std::vector<std::int64_t> event_frames = schedule_events(scenario, step_count(scenario)).frames;
  std::vector<Input> inputs;
  for (std::size_t event = 0; event < event_frames.size() && event_frames[event] < frames; ++event) {
    const Action& action = scenario.events[event].action;
    const auto* const resize = std::get_if<Resize>(&action);
    if (resize != nullptr && resize->window && resize->sprite) {
      inputs.push_back({event_frames[event], Resize{resize->window, {}}});
      inputs.push_back({event_frames[event], Resize{{}, resize->sprite}});
    } else {
      inputs.push_back({event_frames[event], action});
    }
  }
  return inputs;
}

}  // namespace hyrax

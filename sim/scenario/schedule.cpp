#include "sim/scenario/schedule.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "sim/scenario/frame_clock.h"
#include "sim/scenario/timeline.h"

namespace hyrax {
namespace {

constexpr double kTolerance = 1e-9;  // Of a dt, so that at_s = 2.0 at 60 Hz means frame 120.

// Walks the start times of frames forwards, events in order.
class Walk {
 public:
  Walk(const Scenario& scenario, std::int64_t steps) : clock_(scenario.clock), steps_(steps) {}

  void play_to(std::int64_t frame) {
    while (frame_ < frame) play(is_even() ? frame - frame_ : 1);
  }

  // Walks on to the first frame that starts at `at_s` or later; to the end where there is none.
  void play_to_time(double at_s) {
    while (frame_ < steps_ && !(timeline_.time_s() >= at_s - kTolerance * clock_.nominal_dt_s(frame_)))
      play(is_even() ? frames_short_of(at_s) : 1);
  }

  // Whether a frame that lies behind starts at `at_s` or later already.
  bool has_passed(double at_s) const { return at_s <= reach_s_; }

  std::int64_t frame() const { return frame_; }
  void hitch(double dt_s) { hitch_dt_s_ = dt_s; }

 private:
  bool is_even() const { return clock_.is_fixed() && !hitch_dt_s_; }

  void play(std::int64_t count) {
    const double dt_s = hitch_dt_s_.value_or(clock_.dt_s(frame_));
    hitch_dt_s_.reset();
    const double nominal_dt_s = clock_.nominal_dt_s(frame_ + count - 1);
    Timeline last_start = timeline_;
    if (count > 1) last_start.play(dt_s, count - 1);
    reach_s_ = std::max(reach_s_, last_start.time_s() + kTolerance * nominal_dt_s);
    timeline_.play(dt_s, count);
    frame_ += count;
  }

  // At least one frame, and never past the one looked for: a relative 1e-12 is taken off the
  // quotient, far more than its rounding.
  std::int64_t frames_short_of(double at_s) const {
    const double frames = (at_s - timeline_.time_s()) / clock_.dt_s(frame_) * (1.0 - 1e-12) - 1.0;
    const std::int64_t left = steps_ - frame_;
    if (!(frames < static_cast<double>(left))) return left;
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(frames));
  }

  FrameClock clock_;
  std::int64_t steps_;
  std::int64_t frame_ = 0;
  Timeline timeline_;
  std::optional<double> hitch_dt_s_;
  double reach_s_ = -std::numeric_limits<double>::infinity();
};

// Goes to the event's frame.
std::optional<ScheduleFault> go_to(Walk& walk, const Event& event, std::int64_t steps) {
  if (const auto* step = std::get_if<std::int64_t>(&event.when)) {
    if (*step >= steps) return ScheduleFault::beyond_end;
    if (*step < walk.frame()) return ScheduleFault::goes_backwards;
    walk.play_to(*step);
    return std::nullopt;
  }
  const double at_s = std::get<double>(event.when);
  if (walk.has_passed(at_s)) return ScheduleFault::goes_backwards;
  walk.play_to_time(at_s);
  if (walk.frame() >= steps) return ScheduleFault::beyond_end;
  return std::nullopt;
}

}  // namespace

Schedule schedule_events(const Scenario& scenario, std::int64_t steps) {
  Schedule schedule;
  Walk walk(scenario, steps);
  for (const Event& event : scenario.events) {
    if (const auto fault = go_to(walk, event, steps)) {
      schedule.faulty.push_back({schedule.frames.size(), *fault});
      schedule.frames.push_back(-1);
      continue;
    }
    schedule.frames.push_back(walk.frame());
    if (const auto* hitch = std::get_if<Hitch>(&event.action)) walk.hitch(hitch->dt_s);
  }
  return schedule;
}

}  // namespace hyrax

// Which frame each event of a scenario falls on, and the inputs that come of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// With jitter, frames have to be walked one by one to find the frame of an `at_s`: up to this one.
inline constexpr std::int64_t kWalkedFrameMax = 100'000'000;

/// Why an event has no frame; too_far: an `at_s` beyond the last frame that is walked of a jittered clock.
enum class ScheduleFault { beyond_end, goes_backwards, too_far };

struct Schedule {
  /// Frame of each event, in file order; -1 where it has none.
  std::vector<std::int64_t> frames;
  struct Faulty {
    std::size_t event;
    ScheduleFault fault;
  };
  std::vector<Faulty> faulty;
};

/// What decides on which frame an event falls, and how it moves later ones.
struct EventTime {
  std::variant<std::int64_t, double> when;  ///< As Event::when.
  std::optional<double> hitch_dt_s;
};

/// The frame of every event: its `step`, or for `at_s` the first frame whose start time t is
/// >= at_s - 1e-9 * dt, with dt the clock's base, or that frame's in a trace. Hitches move the
/// times of all later frames. Takes time in proportion to the frames only under jitter or a trace; where
/// searches that found no frame have walked `walked_frame_max` frames in all, every later `at_s` has
/// frame -1 and no fault of its own.
/// REQUIRES: numbers within the limits of scenario.h; `steps` = step_count of the scenario; walked_frame_max
/// > 0.
[[nodiscard]] Schedule schedule_events(const Clock& clock, const std::vector<EventTime>& events,
                                       std::int64_t steps, std::int64_t walked_frame_max = kWalkedFrameMax);
[[nodiscard]] Schedule schedule_events(const Scenario& scenario, std::int64_t steps,
                                       std::int64_t walked_frame_max = kWalkedFrameMax);

/// An action, as it is applied before a frame. One that resizes window and sprite is two inputs.
struct Input {
  std::int64_t frame = 0;
  Action action;
  bool operator==(const Input&) const = default;
};

[[nodiscard]] bool same_bits(const Input& a, const Input& b);

/// The inputs of a run of the scenario's first `frames` frames.
[[nodiscard]] std::vector<Input> inputs_of(const Scenario& scenario, std::int64_t frames);

}  // namespace hyrax

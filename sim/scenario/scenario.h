// One scripted fling as a plain value, with the limits its numbers must keep.
//
// The file format `hyrax-scenario/1` says the same in JSON; tools/files reads and writes it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/motion/state.h"

namespace hyrax {

inline constexpr std::int64_t kWindowSideMax_px = 1'000'000;
inline constexpr std::int64_t kSpriteSideMin_px = 1;
inline constexpr std::int64_t kSpriteSideMax_px = 1'000'000;
inline constexpr double kCoordinateMax_px = 1e12;  ///< Also the limit of speeds, in px/s.
inline constexpr double kSpeedMax_px_per_s = 1e12;
inline constexpr double kRateMax_hz = 1e9;
inline constexpr double kFrameMax_s = 1e9;     ///< The longest dt, a jittered one too.
inline constexpr double kParameterMax = 1e12;  ///< Of its magnitude.
inline constexpr std::int64_t kStepsMax = 1'000'000'000'000;
inline constexpr std::int64_t kNameLengthMax = 64;

struct Jitter {
  enum class Kind { uniform, normal, missed_frames };
  Kind kind = Kind::uniform;
  double amount =
      0.0;  ///< uniform: fraction 0 .. 1; normal: sigma in s, 0 .. 1e9; missed_frames: probability 0 .. 1.
  std::uint64_t seed = 0;
  bool operator==(const Jitter&) const = default;
};

struct FixedRate {
  double rate_hz = 60.0;  ///< > 0, at most kRateMax_hz; dt = 1.0 / rate.
  bool operator==(const FixedRate&) const = default;
};
struct FixedStep {
  double dt_s = 0.0;  ///< 0 .. kFrameMax_s.
  bool operator==(const FixedStep&) const = default;
};
/// A recorded trace: one dt a frame, each 0 .. kFrameMax_s, at least one.
struct RecordedSteps {
  std::vector<double> dt_s;
  bool operator==(const RecordedSteps&) const = default;
};

struct Clock {
  std::variant<FixedRate, FixedStep, RecordedSteps> base;
  std::optional<Jitter> jitter;  ///< Not with RecordedSteps.
  bool operator==(const Clock&) const = default;
};

struct Fling {
  Velocity velocity;
  bool operator==(const Fling&) const = default;
};
struct Place {
  Position position;
  bool operator==(const Place&) const = default;
};
struct Stop {
  bool operator==(const Stop&) const = default;
};
struct Resize {
  std::optional<Size> window;  ///< At least one of the two.
  std::optional<Size> sprite;
  bool operator==(const Resize&) const = default;
};
struct Hitch {
  double dt_s = 0.0;  ///< 0 .. kFrameMax_s; replaces the frame's dt.
  bool operator==(const Hitch&) const = default;
};
struct Grab {
  bool operator==(const Grab&) const = default;
};
struct Release {
  Velocity velocity;
  bool operator==(const Release&) const = default;
};
using Action = std::variant<Fling, Place, Stop, Resize, Hitch, Grab, Release>;
inline constexpr std::array<std::string_view, std::variant_size_v<Action>> kActionNames = {
    "fling", "place", "stop", "resize", "hitch", "grab", "release"};
[[nodiscard]] constexpr std::string_view name_of(const Action& action) {
  return kActionNames[action.index()];
}
/// An action of that kind, its numbers 0. REQUIRES: kind < kActionNames.size().
[[nodiscard]] Action make_action(std::size_t kind);

struct Event {
  std::variant<std::int64_t, double> when;  ///< Frame number, or a time in s.
  Action action;
  bool operator==(const Event&) const = default;
};

/// A constant of the core by the core's own name of it, with the value that it has in this run.
struct Parameter {
  std::string name;
  double value = 0.0;
  bool operator==(const Parameter&) const = default;
};

/// Gives the constants of these names the parameters' values. Returns the first parameter of another name;
/// nullptr: there is none.
const Parameter* set_parameters(const std::vector<Parameter>& parameters, const ConstantNames& names,
                                Constants& constants);

/// Both ends inclusive and finite, but low is -infinity where at_rest_since_s has no lower end.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const Interval&) const = default;
};

/// What the author means to hold; each rule only where it is set.
struct Expect {
  std::optional<bool> in_bounds;
  std::optional<bool> finite;
  std::optional<Interval> final_x_px;
  std::optional<Interval> final_y_px;
  std::optional<Interval> at_rest_since_s;
  PerWall<std::optional<Interval>> contacts;
  std::optional<std::string> state_hash;  ///< 32 lower-case hex digits.
  std::optional<double> implementation_px_max;
  std::optional<double> truncation_px_max;
  std::optional<double> energy_drift_rel_max;
  bool operator==(const Expect&) const = default;
};

/// What scenarios of all cores have.
struct ScenarioHead {
  std::string name;  ///< [a-z0-9-]{1,64}.
  std::optional<std::string> description;
  std::optional<std::string> schema;  ///< `$schema`, for editors.
  Clock clock;
  /// Frames to play, or seconds from which they follow; neither where the trace's length says it.
  std::variant<std::monostate, std::int64_t, double> length;
  std::int64_t record_every = 1;  ///< Rows 0, K, 2K, ... and the last one are recorded.
  bool operator==(const ScenarioHead&) const = default;
};

struct Scenario : ScenarioHead {
  Size window;
  Size sprite;
  Position start;
  Velocity start_velocity;
  std::vector<Event> events;
  std::vector<Parameter> parameters;  ///< By name, each once; the core's other constants are its own.
  std::optional<Expect> expect;
  bool operator==(const Scenario&) const = default;
};

[[nodiscard]] inline State start_state(const Scenario& scenario) {
  return {scenario.start.x_px, scenario.start.y_px, scenario.start_velocity.vx_px_per_s,
          scenario.start_velocity.vy_px_per_s};
}

/// So many frames from there on, without a name.
[[nodiscard]] inline Scenario scenario_from(const State& start, const Size& window, const Size& sprite,
                                            double rate_hz, std::int64_t frames) {
  Scenario scenario;
  scenario.window = window;
  scenario.sprite = sprite;
  scenario.start = {start.x_px, start.y_px};
  scenario.start_velocity = velocity_of(start);
  scenario.clock.base = FixedRate{rate_hz};
  scenario.length = frames;
  return scenario;
}

/// Without name, description, expect and schema: what does not change the run.
[[nodiscard]] Scenario without_texts(Scenario scenario);

/// Whether two scenarios play the same run: without texts they are the same.
[[nodiscard]] bool plays_the_same(const Scenario& a, const Scenario& b);

}  // namespace hyrax

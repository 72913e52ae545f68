// The numbers of a scenario: where each is stored, its limits, and the JSON Pointer of its key.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// What a key of the format `hyrax-scenario/1` holds: a real number, a whole number, or a seed, which may be
/// up to 2^64 - 1. Of cores that describe themselves an unsigned number is a seed, true or false one of 1 and
/// 0.
enum class ScenarioNumberKind : std::uint8_t { real, integer, seed, boolean };

/// A number of a scenario: where it is stored, and the limits of its key.
struct NumberField {
  std::variant<double*, std::int32_t*, std::int64_t*, std::uint64_t*> at;
  double low = 0.0;
  double high = 0.0;
  /// Whether frame numbers or times of events may depend on it.
  bool is_timing = false;

  [[nodiscard]] bool allows(double value) const { return value >= low && value <= high; }
  [[nodiscard]] double value() const {
    return std::visit([](const auto* number) { return static_cast<double>(*number); }, at);
  }
  /// REQUIRES: the type of the number has the value.
  void set(double value) const {
    std::visit(
        [value](auto* number) { *number = static_cast<std::remove_pointer_t<decltype(number)>>(value); }, at);
  }
};

/// Of the key that a pointer ends in.
[[nodiscard]] ScenarioNumberKind number_kind(std::string_view pointer);

/// The number at a pointer, as `/start/x_px` or `/events/0/fling/vx_px_per_s`. It refers to the scenario.
/// Nothing if the scenario holds no number there, or in `expect`.
[[nodiscard]] std::optional<NumberField> number_at(Scenario& scenario, std::string_view pointer);

/// All real numbers, sizes and seeds, in the order of the file; frame numbers are none of them. They refer to
/// the scenario.
[[nodiscard]] std::vector<NumberField> numbers_of(Scenario& scenario);

[[nodiscard]] inline NumberField coordinate_field(double& value_px) {
  return {&value_px, -kCoordinateMax_px, kCoordinateMax_px};
}
[[nodiscard]] inline NumberField speed_field(double& value_px_per_s) {
  return {&value_px_per_s, -kSpeedMax_px_per_s, kSpeedMax_px_per_s};
}
[[nodiscard]] inline NumberField frame_field(double& dt_s) { return {&dt_s, 0.0, kFrameMax_s, true}; }
[[nodiscard]] inline NumberField window_field(std::int32_t& side_px) {
  return {&side_px, 0.0, double(kWindowSideMax_px)};
}
[[nodiscard]] inline NumberField sprite_field(std::int32_t& side_px) {
  return {&side_px, double(kSpriteSideMin_px), double(kSpriteSideMax_px)};
}

[[nodiscard]] inline NumberField parameter_field(double& value) {
  return {&value, -kParameterMax, kParameterMax};
}

/// How files name a jitter's kind and its amount, and the largest amount; the least is 0.
struct JitterKeys {
  std::string_view kind;
  std::string_view amount;
  double amount_max;
};
inline constexpr std::array<JitterKeys, 3> kJitterKeys = {{{"uniform", "fraction", 1.0},  // By Jitter::Kind.
                                                           {"normal", "sigma_s", kFrameMax_s},
                                                           {"missed_frames", "probability", 1.0}}};

/// Calls visit(key, NumberField) for each number of the start in the order of the file, as visit_numbers does
/// for those of an action.
void visit_start(Position& start, Velocity& velocity, const auto& visit) {
  visit("x_px", coordinate_field(start.x_px));
  visit("y_px", coordinate_field(start.y_px));
  visit("vx_px_per_s", speed_field(velocity.vx_px_per_s));
  visit("vy_px_per_s", speed_field(velocity.vy_px_per_s));
}

/// Calls visit(path, NumberField) for each number of an action in the order of the file: the one list of them
/// that files, sweeps, searches and the report page share. The path is that in the action's member of the
/// file, as "vx_px_per_s" or "window/width_px". A size that a resize leaves as it is has no numbers.
void visit_numbers(Action& action, const auto& visit) {
  const auto visit_kind = [&visit]<class Kind>(Kind& of) {
    if constexpr (requires { of.velocity; }) {
      visit("vx_px_per_s", speed_field(of.velocity.vx_px_per_s));
      visit("vy_px_per_s", speed_field(of.velocity.vy_px_per_s));
    } else if constexpr (requires { of.position; }) {
      visit("x_px", coordinate_field(of.position.x_px));
      visit("y_px", coordinate_field(of.position.y_px));
    } else if constexpr (std::is_same_v<Kind, Resize>) {
      if (of.window) {
        visit("window/width_px", window_field(of.window->width_px));
        visit("window/height_px", window_field(of.window->height_px));
      }
      if (of.sprite) {
        visit("sprite/width_px", sprite_field(of.sprite->width_px));
        visit("sprite/height_px", sprite_field(of.sprite->height_px));
      }
    } else if constexpr (std::is_same_v<Kind, Hitch>) {
      visit("dt_s", frame_field(of.dt_s));
    } else {
      static_assert(std::is_empty_v<Kind>);
    }
  };
  std::visit(visit_kind, action);
}

}  // namespace hyrax

// The paper's step with its constants and its parts free: what studies vary.
//
// With all parts and the constants of class physics it is physics::update bit for bit,
// to which a test holds it. It moves no sprite in a result that is called exact, but says what a step of the
// core met on its way: which walls, how fast, how far past them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/motion/state.h"

namespace hyrax {

/// The parts of the model and of the window.
enum class ModelPart : std::uint8_t {
  gravity,
  drag,
  left_wall,
  right_wall,
  top_wall,
  ground,
  friction,
  restitution,
  rest_rule
};

inline constexpr std::size_t kModelPartCount = 9;
inline constexpr std::array<std::string_view, kModelPartCount> kModelPartNames = {
    "gravity", "drag", "left wall", "right wall", "top", "ground", "friction", "restitution", "rest rule"};

/// Which parts a step has; all of them at first.
class ModelParts {
 public:
  [[nodiscard]] constexpr bool has(ModelPart part) const {
    return (left_out_ >> static_cast<unsigned>(part) & 1u) == 0;
  }
  constexpr void leave_out(ModelPart part) { left_out_ |= 1u << static_cast<unsigned>(part); }

 private:
  unsigned left_out_ = 0;
};

/// All parts but one, known when the step is compiled, so that what is left out costs nothing.
template <ModelPart kPart>
struct AllBut {
  [[nodiscard]] static constexpr bool has(ModelPart part) { return part != kPart; }
};
struct AllParts {
  [[nodiscard]] static constexpr bool has(ModelPart) { return true; }
};

/// One step, an operation each. What a part left out does not do: gravity adds nothing, drag and friction
/// keep the speed, a wall lets the sprite through, restitution keeps the speed's size, the rest rule never
/// sets vy to 0.
template <class PartSet>
class ListingStep {
 public:
  ListingStep(const Constants& constants, const PartSet& parts, const Bounds& bounds)
      : constants_(constants), parts_(parts), bounds_(bounds) {}

  void pull(State& s, double dt_s) const {
    if (parts_.has(ModelPart::gravity)) s.vy_px_per_s += constants_.gravity_px_per_s2 * dt_s;
  }
  void drag(State& s) const {
    if (!parts_.has(ModelPart::drag)) return;
    s.vx_px_per_s *= constants_.air_drag;
    s.vy_px_per_s *= constants_.air_drag;
  }
  void move(State& s, double dt_s) const {
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
  }
  /// The flight of one frame, as if there were no walls.
  [[gnu::always_inline]] void fly(State& s, double dt_s) const {
    pull(s, dt_s);
    drag(s);
    move(s, dt_s);
  }
  /// Returns the wall that clamped as a row's contact byte has it; 0: none.
  std::uint8_t meet_walls_in_x(State& s) const {
    if (parts_.has(ModelPart::left_wall) && s.x_px < 0.0) {
      s.x_px = 0.0;
      s.vx_px_per_s = turned(s.vx_px_per_s);
      return static_cast<std::uint8_t>(Wall::left);
    }
    if (parts_.has(ModelPart::right_wall) && s.x_px > bounds_.right_px) {
      s.x_px = bounds_.right_px;
      s.vx_px_per_s = turned(s.vx_px_per_s);
      return static_cast<std::uint8_t>(Wall::right);
    }
    return 0;
  }
  std::uint8_t meet_walls_in_y(State& s) const {
    if (parts_.has(ModelPart::top_wall) && s.y_px < 0.0) {
      s.y_px = 0.0;
      s.vy_px_per_s = turned(s.vy_px_per_s);
      return static_cast<std::uint8_t>(Wall::top);
    }
    if (parts_.has(ModelPart::ground) && s.y_px > bounds_.bottom_px) {
      s.y_px = bounds_.bottom_px;
      s.vy_px_per_s = turned(s.vy_px_per_s);
      if (parts_.has(ModelPart::friction)) s.vx_px_per_s *= constants_.ground_friction;
      if (parts_.has(ModelPart::rest_rule) && std::fabs(s.vy_px_per_s) < constants_.rest_threshold_px_per_s)
        s.vy_px_per_s = 0.0;
      return static_cast<std::uint8_t>(Wall::ground);
    }
    return 0;
  }

  /// The paper's order. Returns the walls that clamped.
  [[gnu::always_inline]] std::uint8_t operator()(State& s, double dt_s) const {
    fly(s, dt_s);
    const std::uint8_t in_x = meet_walls_in_x(s);
    return static_cast<std::uint8_t>(in_x | meet_walls_in_y(s));
  }

 private:
  [[nodiscard]] double turned(double speed_px_per_s) const {
    return parts_.has(ModelPart::restitution) ? -speed_px_per_s * constants_.restitution : -speed_px_per_s;
  }

  Constants constants_;
  PartSet parts_;
  Bounds bounds_;
};

}  // namespace hyrax

// The vocabulary of motion: plain values that every folder shares.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace hyrax {

struct Size {
  std::int32_t width_px = 0;
  std::int32_t height_px = 0;
  bool operator==(const Size&) const = default;
};

/// Top left corner of the sprite; x grows to the right, y downwards.
struct Position {
  double x_px = 0.0;
  double y_px = 0.0;
  bool operator==(const Position&) const = default;
};

struct Velocity {
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
  bool operator==(const Velocity&) const = default;
};

/// Top left corner and velocity of the sprite.
struct State {
  double x_px = 0.0;
  double y_px = 0.0;
  double vx_px_per_s = 0.0;
  double vy_px_per_s = 0.0;
};

/// Equality of bits: +0 and -0 differ, a NaN equals itself.
[[nodiscard]] inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
[[nodiscard]] inline bool same_bits(const State& a, const State& b) {
  return same_bits(a.vy_px_per_s, b.vy_px_per_s) && same_bits(a.y_px, b.y_px) && same_bits(a.x_px, b.x_px) &&
         same_bits(a.vx_px_per_s, b.vx_px_per_s);
}

[[nodiscard]] inline bool is_finite(const State& state) {
  return std::isfinite(state.x_px) && std::isfinite(state.y_px) && std::isfinite(state.vx_px_per_s) &&
         std::isfinite(state.vy_px_per_s);
}

/// Where the top left corner may be: 0 .. right, 0 .. bottom. Negative where the sprite is larger than the
/// window.
struct Bounds {
  double right_px = 0.0;
  double bottom_px = 0.0;
  bool operator==(const Bounds&) const = default;
};

[[nodiscard]] inline Bounds bounds_of(const Size& window, const Size& sprite) {
  return {static_cast<double>(window.width_px - sprite.width_px),
          static_cast<double>(window.height_px - sprite.height_px)};
}

/// All that the next step depends on, but its dt.
struct World {
  State state;
  Size window;
  Size sprite;
  bool is_held = false;

  [[nodiscard]] Bounds bounds() const { return bounds_of(window, sprite); }
};

/// The constants of the paper's table. Their values are those of class physics (sim/physics/physics.h).
struct Constants {
  double gravity_px_per_s2 = 0.0;
  double restitution = 0.0;              ///< [-], ratio of speeds after and before a bounce.
  double air_drag = 0.0;                 ///< [-], velocity factor of a step.
  double ground_friction = 0.0;          ///< [-], horizontal velocity factor of a ground contact.
  double rest_threshold_px_per_s = 0.0;  ///< Below it a ground contact sets vy to 0.
};

}  // namespace hyrax

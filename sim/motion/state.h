// The vocabulary of motion: plain values that every folder shares.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

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

[[nodiscard]] inline Velocity velocity_of(const State& state) {
  return {state.vx_px_per_s, state.vy_px_per_s};
}

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

/// All that the next step depends on, except its dt. A body that apply (sim/scenario/apply.h) can act on.
struct World {
  State state;
  Size window;
  Size sprite;
  bool is_held = false;

  [[nodiscard]] Bounds bounds() const { return bounds_of(window, sprite); }
  void setPos(double x_px, double y_px) {
    state.x_px = x_px;
    state.y_px = y_px;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    state.vx_px_per_s = vx_px_per_s;
    state.vy_px_per_s = vy_px_per_s;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }
};

/// The constants of the paper's table. Their values are those of class physics (sim/physics/physics.h).
struct Constants {
  double gravity_px_per_s2 = 0.0;
  double restitution = 0.0;              ///< [-], ratio of speeds after and before a bounce.
  double air_drag = 0.0;                 ///< [-], velocity factor of a step.
  double ground_friction = 0.0;          ///< [-], horizontal velocity factor of a ground contact.
  double rest_threshold_px_per_s = 0.0;  ///< Below it a ground contact sets vy to 0.
};

/// In the order in which the paper's step needs them.
inline constexpr std::array<double Constants::*, 5> kConstantFields = {
    &Constants::gravity_px_per_s2, &Constants::air_drag, &Constants::restitution, &Constants::ground_friction,
    &Constants::rest_threshold_px_per_s};
using ConstantNames = std::array<std::string_view, kConstantFields.size()>;
inline constexpr ConstantNames kPaperNames = {"GRAVITY", "AIR_DRAG", "RESTITUTION", "GROUND_FRICTION",
                                              "REST_THRESHOLD"};

/// Whether a class has them by the paper's names.
template <class Physics>
concept HasPaperConstants = requires {
  Physics::GRAVITY + Physics::RESTITUTION + Physics::AIR_DRAG + Physics::GROUND_FRICTION +
      Physics::REST_THRESHOLD;
};
template <HasPaperConstants Physics>
[[nodiscard]] Constants constants_of() {
  return {.gravity_px_per_s2 = Physics::GRAVITY,
          .restitution = Physics::RESTITUTION,
          .air_drag = Physics::AIR_DRAG,
          .ground_friction = Physics::GROUND_FRICTION,
          .rest_threshold_px_per_s = Physics::REST_THRESHOLD};
}

/// The names of those that are of type double, as the values of a scenario are; else empty.
template <HasPaperConstants Physics>
[[nodiscard]] constexpr ConstantNames constant_names_of() {
  constexpr bool kAreDouble[] = {std::is_same_v<decltype(Physics::GRAVITY), const double>,
                                 std::is_same_v<decltype(Physics::AIR_DRAG), const double>,
                                 std::is_same_v<decltype(Physics::RESTITUTION), const double>,
                                 std::is_same_v<decltype(Physics::GROUND_FRICTION), const double>,
                                 std::is_same_v<decltype(Physics::REST_THRESHOLD), const double>};
  ConstantNames names = kPaperNames;
  for (std::size_t place = 0; place < names.size(); ++place)
    if (!kAreDouble[place]) names[place] = {};
  return names;
}

[[nodiscard]] inline bool same_bits(const Constants& a, const Constants& b) {
  return same_bits(a.gravity_px_per_s2, b.gravity_px_per_s2) && same_bits(a.restitution, b.restitution) &&
         same_bits(a.air_drag, b.air_drag) && same_bits(a.ground_friction, b.ground_friction) &&
         same_bits(a.rest_threshold_px_per_s, b.rest_threshold_px_per_s);
}

/// Bits of a row's contact byte; in flight it is 0.
enum class Wall : std::uint8_t { left = 1, right = 2, top = 4, ground = 8 };

/// Set beside Wall::ground where the rest rule zeroed the vertical speed.
inline constexpr std::uint8_t kRestBit = 16;

inline constexpr std::array<Wall, 4> kWalls = {Wall::left, Wall::right, Wall::top, Wall::ground};
inline constexpr std::array<std::string_view, 4> kWallNames = {"left", "right", "top", "ground"};

/// 0 .. 3, the wall's place in kWalls.
constexpr std::size_t wall_index(Wall wall) {
  return static_cast<std::size_t>(std::countr_zero(static_cast<std::uint8_t>(wall)));
}

constexpr std::string_view name_of(Wall wall) { return kWallNames[wall_index(wall)]; }

constexpr bool touches(std::uint8_t contact, Wall wall) {
  return (contact & static_cast<std::uint8_t>(wall)) != 0;
}

/// A wall that a step met.
struct WallMeeting {
  double overshoot_px = 0.0;  ///< >= 0; how far beyond the wall the position was. NaN: not known.
  Velocity before;            ///< As it met the wall.
  Velocity after;             ///< At the next wall, or after the step.
};

/// A value for each wall.
template <class Value>
struct PerWall {
  Value left{}, right{}, top{}, ground{};

  [[nodiscard]] constexpr Value& operator[](Wall wall) {
    Value* const values[] = {&left, &right, &top, &ground};
    return *values[wall_index(wall)];
  }
  [[nodiscard]] constexpr Value operator[](Wall wall) const { return PerWall(*this)[wall]; }
  [[nodiscard]] constexpr Value total() const { return left + right + top + ground; }
  bool operator==(const PerWall&) const = default;
};
using WallCounts = PerWall<std::int64_t>;

}  // namespace hyrax

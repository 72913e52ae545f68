// The paper's step with parts that can be left out: what each of them does to a scene.
//
// Never a result that is called exact; with every part it is physics::update bit for bit, to which a test
// holds it.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "sim/physics/physics.h"
#include "sim/study/motion.h"
#include "sim/trajectory/wall.h"

namespace hyrax {

/// The parts of the model and of the room.
enum class Part : std::uint8_t {
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

inline constexpr std::size_t kPartCount = 9;
inline constexpr std::array<std::string_view, kPartCount> kPartNames = {
    "gravity", "drag", "left wall", "right wall", "top", "ground", "friction", "restitution", "rest rule"};

/// Which parts a step has; all of them at first.
class Parts {
 public:
  [[nodiscard]] constexpr bool has(Part part) const {
    return (left_out_ >> static_cast<unsigned>(part) & 1u) == 0;
  }
  constexpr void leave_out(Part part) { left_out_ |= 1u << static_cast<unsigned>(part); }

 private:
  unsigned left_out_ = 0;
};

/// All parts but one, known when the step is compiled, so that what is left out costs nothing.
template <Part kPart>
struct AllBut {
  [[nodiscard]] static constexpr bool has(Part part) { return part != kPart; }
};
struct AllParts {
  [[nodiscard]] static constexpr bool has(Part) { return true; }
};

/// One frame. Left out: gravity adds nothing, drag and friction keep the speed, a wall lets the sprite
/// through, restitution turns the speed whole, the rest rule never stops it.
/// Returns the walls that clamped, as a row's contact byte has them.
template <class PartSet>
[[gnu::always_inline]] inline std::uint8_t step(Motion& m, double dt_s, const Room& room,
                                                const PartSet& parts) {
  const double right_px = room.right_px();
  const double bottom_px = room.bottom_px();
  const auto turned = [&parts](double speed_px_per_s) {
    return parts.has(Part::restitution) ? -speed_px_per_s * physics::RESTITUTION : -speed_px_per_s;
  };
  std::uint8_t contact = 0;

  if (parts.has(Part::gravity)) m.vy_px_per_s += physics::GRAVITY * dt_s;
  if (parts.has(Part::drag)) {
    m.vx_px_per_s *= physics::AIR_DRAG;
    m.vy_px_per_s *= physics::AIR_DRAG;
  }
  m.x_px += m.vx_px_per_s * dt_s;
  m.y_px += m.vy_px_per_s * dt_s;

  if (parts.has(Part::left_wall) && m.x_px < 0.0) {
    m.x_px = 0.0;
    m.vx_px_per_s = turned(m.vx_px_per_s);
    contact = static_cast<std::uint8_t>(Wall::left);
  } else if (parts.has(Part::right_wall) && m.x_px > right_px) {
    m.x_px = right_px;
    m.vx_px_per_s = turned(m.vx_px_per_s);
    contact = static_cast<std::uint8_t>(Wall::right);
  }
  if (parts.has(Part::top_wall) && m.y_px < 0.0) {
    m.y_px = 0.0;
    m.vy_px_per_s = turned(m.vy_px_per_s);
    contact = static_cast<std::uint8_t>(contact | static_cast<std::uint8_t>(Wall::top));
  } else if (parts.has(Part::ground) && m.y_px > bottom_px) {
    m.y_px = bottom_px;
    m.vy_px_per_s = turned(m.vy_px_per_s);
    if (parts.has(Part::friction)) m.vx_px_per_s *= physics::GROUND_FRICTION;
    if (parts.has(Part::rest_rule) && std::fabs(m.vy_px_per_s) < physics::REST_THRESHOLD) m.vy_px_per_s = 0.0;
    contact = static_cast<std::uint8_t>(contact | static_cast<std::uint8_t>(Wall::ground));
  }
  return contact;
}

}  // namespace hyrax

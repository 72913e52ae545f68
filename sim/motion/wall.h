// Which walls clamped a step.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace hyrax {

/// Bits of a row's contact byte; in flight it is 0.
enum class Wall : std::uint8_t { left = 1, right = 2, top = 4, ground = 8 };

/// Set beside Wall::ground where the rest rule zeroed the vertical speed.
inline constexpr std::uint8_t kRestBit = 16;

inline constexpr std::array<Wall, 4> kWalls = {Wall::left, Wall::right, Wall::top, Wall::ground};
inline constexpr std::array<std::string_view, 4> kWallNames = {"left", "right", "top", "ground"};

/// 0 .. 3, the wall's place in kWalls.
constexpr std::size_t wall_index(Wall wall) {
  switch (wall) {
    case Wall::left:
      return 0;
    case Wall::right:
      return 1;
    case Wall::top:
      return 2;
    case Wall::ground:
      return 3;
  }
  return 0;
}

constexpr bool touches(std::uint8_t contact, Wall wall) {
  return (contact & static_cast<std::uint8_t>(wall)) != 0;
}

}  // namespace hyrax

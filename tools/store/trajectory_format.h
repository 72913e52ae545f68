// The format `hyrax-trajectory/1`, as golden/README.md describes it: what reader and writers share.
#pragma once

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/motion/state.h"
#include "sim/result/table.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/contact.h"

namespace hyrax {

inline constexpr std::string_view kTrajectoryFormat = "hyrax-trajectory/1";

/// A column of doubles, with its place in a batch of rows.
/// A new one is added to Row and Columns, and here: every reader and writer of rows uses this list.
using RowColumn = ColumnOf<Row, std::vector<double> Columns::*>;

inline constexpr std::array<RowColumn, 6> kRowColumns = {{
    {"t", "s", "time since the start", &Row::t_s, "", {}, &Columns::t_s},
    {"dt", "s", "duration of the frame", &Row::dt_s, "", {}, &Columns::dt_s},
    {"x", "px", "left edge of the sprite, to the right", &Row::x_px, "", {}, &Columns::x_px},
    {"y", "px", "top edge of the sprite, downwards", &Row::y_px, "", {}, &Columns::y_px},
    {"vx", "px/s", "velocity to the right", &Row::vx_px_per_s, "", {}, &Columns::vx_px_per_s},
    {"vy", "px/s", "velocity downwards", &Row::vy_px_per_s, "", {}, &Columns::vy_px_per_s},
}};

/// The flags of a row's contact byte.
inline constexpr std::array<std::uint8_t, 5> kContactFlags = {1, 2, 4, 8, kRestBit};
inline constexpr std::array<std::string_view, 5> kContactFlagNames = {"left", "right", "top", "ground",
                                                                      "rest"};

inline constexpr ColumnOf<Contact> kContactColumns[] = {
    {"step", "", "first clamped row", &Contact::step},
    {"last_step", "", "last clamped row", &Contact::last_step},
    {"wall", "", "wall: 1 left, 2 right, 4 top, 8 ground",
     ColumnOf<Contact>::Code{[](const Contact& c) { return static_cast<std::uint8_t>(c.wall); },
                             {kWallNames, true}}},
    {"t", "s", "time of the first clamped row", &Contact::t_s},
    {"x", "px", "left edge of the sprite", &Contact::x_px},
    {"y", "px", "top edge of the sprite", &Contact::y_px},
    {"vx_before", "px/s", "velocity to the right as it met the wall", &Contact::vx_before_px_per_s},
    {"vy_before", "px/s", "velocity downwards as it met the wall", &Contact::vy_before_px_per_s},
    {"vx_after", "px/s", "velocity to the right after it", &Contact::vx_after_px_per_s},
    {"vy_after", "px/s", "velocity downwards after it", &Contact::vy_after_px_per_s},
    {"overshoot", "px", "how far past the wall the unclamped position was", &Contact::overshoot_px},
};

/// The attributes of `/`.
struct FileHead {
  Scenario scenario;
  std::int64_t steps = 0;
  std::string physics;
  std::string state_hash;  ///< 32 hex digits.
  /// Of the core that played the run: the paper's where the file of a paper's model does not have them,
  /// nothing for a core of one's own.
  std::optional<Constants> constants;
};

/// The numbers of the attribute `constants`, in the order of the paper's table.
using ConstantNumbers = std::array<double, 5>;
[[nodiscard]] constexpr ConstantNumbers numbers_of(const Constants& constants) {
  return {constants.gravity_px_per_s2, constants.restitution, constants.air_drag, constants.ground_friction,
          constants.rest_threshold_px_per_s};
}
[[nodiscard]] constexpr Constants constants_of(const ConstantNumbers& numbers) {
  return {.gravity_px_per_s2 = numbers[0],
          .restitution = numbers[1],
          .air_drag = numbers[2],
          .ground_friction = numbers[3],
          .rest_threshold_px_per_s = numbers[4]};
}

}  // namespace hyrax

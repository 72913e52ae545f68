// A method's run of a problem against the exact fling.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/figure.h"
#include "sim/study/methods/method.h"
#include "sim/study/methods/problem.h"

namespace hyrax {

/// Largest differences over the rows, kRowRate_hz a second and the last one, and the difference at the end.
/// NaN: there is none.
struct MethodErrors {
  bool is_failed = false;  ///< The method gave up; then the other values mean nothing.
  double position_px = 0.0;
  double velocity_px_per_s = 0.0;
  /// Of the largest kinetic energy of the exact fling: it has no datum. Over the rows at which both have met
  /// each wall equally often: where only one has bounced, energies are off by what a bounce takes.
  double energy_rel = 0.0;
  double end_px = 0.0;  ///< Distance of the last positions.
  /// Of the first three impacts of every stage, where both meet the same walls.
  double contact_time_s = kNotGiven;
  /// Another number of impacts on the left wall, right wall or top than the exact fling. Those on the ground
  /// are not compared: how many there are before a sprite lies still depends on every frame.
  bool has_other_contacts = false;
  double coordinate_largest_px = 0.0;  ///< Of the exact fling.
  std::size_t frames = 0;
};

/// On which of kWalls a position is. A method puts a sprite there, so that a row on a wall on which the row
/// before was not is a contact.
[[nodiscard]] inline std::array<bool, kWalls.size()> walls_of(const State& at, const Bounds& bounds) {
  return {at.x_px == 0.0, at.x_px == bounds.right_px, at.y_px == 0.0, at.y_px == bounds.bottom_px};
}

/// @param rate_hz that the frames were made for.
[[nodiscard]] MethodErrors measure_errors(const Core& core, const Problem& problem, const MethodKind& kind,
                                          const std::vector<std::vector<double>>& stage_frames_s,
                                          double rate_hz);

/// Errors below this are the rounding of the run: 40 units in the last place of the largest coordinate, for
/// a random walk of so many frames.
[[nodiscard]] double rounding_px(const MethodErrors& errors);

/// The same run without measurements, to be timed; with stages of no frames, its set-up alone. False if the
/// method failed.
[[nodiscard]] bool play_through(const Problem& problem, Method& method,
                                const std::vector<std::vector<double>>& stage_frames_s);

/// Rows a second that every method gives, and where all are compared. Slower ones have a row a frame.
inline constexpr double kRowRate_hz = 60.0;

}  // namespace hyrax

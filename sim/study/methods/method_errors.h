// A method's run of a problem against the exact fling.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/study/methods/method.h"
#include "sim/study/methods/problem.h"

namespace hyrax {

/// Largest differences over the rows that are 1/15 s apart and the last one, and the difference at the end.
/// NaN: there is none.
struct MethodErrors {
  bool is_failed = false;  ///< The method gave up; then the other values mean nothing.
  double position_px = 0.0;
  double velocity_px_per_s = 0.0;
  double energy_rel = 0.0;  ///< Of the largest energy of the exact fling.
  double end_px = 0.0;      ///< Distance of the last positions.
  double contact_time_s;    ///< Of the first three impacts of every stage, where both meet the same walls.
  double coordinate_largest_px = 0.0;  ///< Of the exact fling.
  std::size_t frames = 0;
};

/// @param rate_hz that the frames were made for.
[[nodiscard]] MethodErrors measure_errors(const Problem& problem, const MethodKind& kind,
                                          const std::vector<std::vector<double>>& stage_frames_s,
                                          double rate_hz);

/// The same run without measurements, to be timed. False if the method failed.
[[nodiscard]] bool play_through(const Problem& problem, Method& method,
                                const std::vector<std::vector<double>>& stage_frames_s);

/// The lowest rate of a study; its rows are where all methods are compared.
inline constexpr double kCheckRate_hz = 15.0;

}  // namespace hyrax

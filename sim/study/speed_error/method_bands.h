// One fling says little: what the methods do with many flings like it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/result/interval.h"
#include "sim/study/methods/method.h"
#include "sim/study/methods/problem.h"

namespace hyrax {

/// The flings of a band, and the seed of their starts.
inline constexpr std::int64_t kBandFlings = 120;
inline constexpr std::uint64_t kBandSeed = 13;
/// How far their starts and speeds are from the problem's. In a frame of 60 Hz a sprite moves some 20 px, so
/// that impacts fall on every phase of a frame.
inline constexpr double kBandStart_px = 20.0;
inline constexpr double kBandSpeed_rel = 0.05;

/// `count` problems like one: the start anywhere within kBandStart_px in x and y, inside the first bounds,
/// each speed within kBandSpeed_rel of itself, jitter of seeds of their own. The first is the problem itself.
[[nodiscard]] std::vector<Problem> problems_like(const Problem& problem, std::int64_t count,
                                                 std::uint64_t seed);

/// One method at one rate, over problems_like(problem, kBandFlings, kBandSeed).
struct MethodBands {
  std::size_t problem = 0;
  std::size_t method = 0;
  double rate_hz = 0.0;
  Band position_px = {};             ///< Largest distance from the exact fling.
  Band end_px = {};                  ///< Distance of the last positions.
  Share nearer = {};                 ///< Flings that end nearer to the exact place than by the paper's step.
  Share other_contacts = {};         ///< MethodErrors::has_other_contacts.
  std::int64_t beyond_rounding = 0;  ///< Flings whose distance is more than rounding.
};

/// Of all methods that meet walls, but adaptive ones and the reference; `problem` is left 0.
/// REQUIRES: the first method is the paper's step.
[[nodiscard]] std::vector<MethodBands> method_bands(const Problem& problem,
                                                    const std::vector<MethodKind>& methods,
                                                    const std::vector<double>& rates_hz);

/// "it is nearer", "it is farther", or "not decided by 120 flings" where the 95 % interval of the share has
/// one half in it.
[[nodiscard]] std::string nearness_text(const Share& nearer);

}  // namespace hyrax

// Random scenarios, each with some of the features that scenarios can have.
//
// Source: A. Groce, C. Zhang, E. Eide, Y. Chen, J. Regehr, "Swarm testing", ISSTA 2012: runs that lack some
// features reach what runs with all of them hide.
#pragma once

#include <bitset>
#include <cstdint>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// What a run may have; each is switched on in half of the runs.
enum class Feature : std::uint8_t {
  corners,       ///< Starts near a corner, towards it.
  on_bounds,     ///< Positions on a bound, to the bit.
  outside,       ///< Positions outside the window, as far as the format allows.
  fast,          ///< Speeds up to the format's limit.
  small_window,  ///< Sides of at most 64 px.
  oversized,     ///< The sprite may be larger than the window.
  resizes,       ///< Events that change sizes.
  hitches,       ///< Events and recorded frames of any dt.
  holds,         ///< Grab, place and release.
  throws,        ///< Fling, place and stop.
  rest,          ///< Starts on the ground, with little or no speed, or that of the rest rule's threshold.
  jitter,        ///< A clock with one of the kinds of jitter.
  recorded,      ///< A recorded clock.
  zero_frames,   ///< Frames of no length.
  any_rate,      ///< Other rates than those of displays.
  long_run,      ///< Once in eight such runs up to 2,000 frames, so that states repeat; else up to 80.
};

inline constexpr std::size_t kFeatureCount = static_cast<std::size_t>(Feature::long_run) + 1;

struct RandomRun {
  Scenario scenario;
  std::vector<std::int64_t> stops;      ///< Two rows, in order: where the run is stopped and resumed.
  std::bitset<kFeatureCount> features;  ///< By Feature.
};

/// Run `run` of a seed: the same on every machine for cores of the same constants, whichever runs come before
/// it. The scenario is within all limits of the format; its name is "fuzz-SEED-RUN".
[[nodiscard]] RandomRun random_run(const Core& core, std::uint64_t seed, std::uint64_t run);

/// A fling of 10 s without events, at the rate of a display, 24 to 360 Hz, with or without jitter; its sizes
/// and its start are those of random runs.
[[nodiscard]] Scenario random_fling(const Core& core, std::uint64_t seed, std::uint64_t number);

}  // namespace hyrax

// Many random flings of a core at one display rate, played at once by sim/ensemble.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/scenario/sweep.h"

namespace hyrax {

/// The paper's desktop: 1920 x 1080 px with a sprite of 128 x 128.
inline constexpr Bounds kDesktop{1792.0, 952.0};
inline constexpr std::uint64_t kFlingSeed = 77;
/// Fling i has the jitter seed kJitterSeed + i mod kJitterSeeds.
inline constexpr std::uint64_t kJitterSeed = 11;
inline constexpr std::int64_t kJitterSeeds = 8;

/// The first `flings` of kFlingSeed at a rate: x, y anywhere, vx -2000 .. 2000, vy -2000 .. 500 px/s. The
/// same flings at every rate and clock. `keep` is final, contacts, at_rest.
class ManyFlings {
 public:
  /// @param duration_s in frames of the clock without jitter. REQUIRES: at least one fling.
  ManyFlings(const Clock& clock, double duration_s, std::int64_t flings);

  [[nodiscard]] std::int64_t frames() const { return std::get<std::int64_t>(sweep_.base.length); }
  [[nodiscard]] State start(std::int64_t fling) const;
  /// The clock, with the seed of the fling.
  [[nodiscard]] Clock clock(std::int64_t fling) const;

  /// Of every fling, the bits that the replay gives.
  [[nodiscard]] std::vector<MemberResult> play(const Core& core) const;

 private:
  Sweep sweep_;
};

}  // namespace hyrax

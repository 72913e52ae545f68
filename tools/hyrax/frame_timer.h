// The time between frames.
#pragma once

#include <cstdint>

namespace hyrax {

/// Counts in ticks of a clock that its owner reads, so that time is an argument and never a surprise.
class FrameTimer {
 public:
  /// REQUIRES: ticks_per_s > 0.
  FrameTimer(std::int64_t ticks_per_s, std::int64_t ticks) : ticks_per_s_(ticks_per_s), last_ticks_(ticks) {}

  /// Time from here on is the next frame's; what went before belongs to no frame.
  void restart(std::int64_t ticks) { last_ticks_ = ticks; }

  /// Seconds since the last frame, 0 of a clock that stands still or goes backwards. A frame ends here.
  [[nodiscard]] double elapsed_s(std::int64_t ticks) {
    const std::int64_t elapsed_ticks = ticks > last_ticks_ ? ticks - last_ticks_ : 0;
    last_ticks_ = ticks;
    return static_cast<double>(elapsed_ticks) / static_cast<double>(ticks_per_s_);
  }

 private:
  std::int64_t ticks_per_s_;
  std::int64_t last_ticks_;
};

}  // namespace hyrax

// The timer of frames.
#pragma once

#include <cstdint>

#include <windows.h>

namespace hyrax {

/// The performance counter, the clock of every frame.
[[nodiscard]] std::int64_t clock_ticks();
[[nodiscard]] std::int64_t clock_ticks_per_s();

/// A timer that is signalled once per frame.
class FramePacer {
 public:
  FramePacer();
  FramePacer(const FramePacer&) = delete;
  FramePacer& operator=(const FramePacer&) = delete;
  ~FramePacer();

  void set_rate(int hz) { period_ticks_ = clock_ticks_per_s() / hz; }
  [[nodiscard]] HANDLE handle() const { return timer_; }
  /// Sets the timer to one period after the last due time, so that the rate is kept; after a late frame to
  /// one period from now. A short frame after a late one would make a settled hyrax hop.
  void arm();

 private:
  HANDLE timer_;
  std::int64_t period_ticks_;
  std::int64_t due_ticks_;
};

}  // namespace hyrax

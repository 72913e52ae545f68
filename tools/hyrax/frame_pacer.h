// When the next frame is due.
#pragma once

#include <cstdint>

#include <windows.h>

namespace hyrax {

/// The performance counter, the clock of every frame.
[[nodiscard]] std::int64_t clock_ticks();
[[nodiscard]] std::int64_t clock_ticks_per_s();

/// A timer that is signalled once a frame; to wait for it costs nothing.
class FramePacer {
 public:
  FramePacer();
  FramePacer(const FramePacer&) = delete;
  FramePacer& operator=(const FramePacer&) = delete;
  ~FramePacer();

  void set_rate(int hz) { period_ticks_ = clock_ticks_per_s() / hz; }
  [[nodiscard]] HANDLE handle() const { return timer_; }
  /// Sets the timer to the next due time: a period after the one before, so that the rate is kept; or, late,
  /// a period from now. A late frame is never followed by a short one: there a hyrax at rest would hop.
  void arm();

 private:
  HANDLE timer_;
  std::int64_t period_ticks_;
  std::int64_t due_ticks_;
};

}  // namespace hyrax

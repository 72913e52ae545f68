#include "tools/hyrax/window.h"

#include <algorithm>

#ifndef CREATE_WAITABLE_TIMER_HIGH_RESOLUTION
#define CREATE_WAITABLE_TIMER_HIGH_RESOLUTION 0x00000002
#endif

namespace hyrax {
namespace {

// Before version 1803 timers have the resolution of the system's ticks, up to 15.6 ms.
HANDLE make_timer() {
  const HANDLE precise =
      CreateWaitableTimerExW(nullptr, nullptr, CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, TIMER_ALL_ACCESS);
  return precise != nullptr ? precise : CreateWaitableTimerExW(nullptr, nullptr, 0, TIMER_ALL_ACCESS);
}

}  // namespace

std::int64_t clock_ticks() {
  LARGE_INTEGER ticks;
  QueryPerformanceCounter(&ticks);
  return ticks.QuadPart;
}

std::int64_t clock_ticks_per_s() {
  LARGE_INTEGER frequency;
  QueryPerformanceFrequency(&frequency);
  return frequency.QuadPart;
}

FramePacer::FramePacer()
    : timer_(make_timer()), period_ticks_(clock_ticks_per_s() / 60), due_ticks_(clock_ticks()) {}

FramePacer::~FramePacer() { CloseHandle(timer_); }

void FramePacer::arm() {
  constexpr std::int64_t kTimerUnitsPerSecond = 10'000'000;
  const std::int64_t now_ticks = clock_ticks();
  due_ticks_ =
      next_due_ticks({.last_due_ticks = due_ticks_, .now_ticks = now_ticks, .period_ticks = period_ticks_});
  LARGE_INTEGER due;
  due.QuadPart =
      -std::max<std::int64_t>((due_ticks_ - now_ticks) * kTimerUnitsPerSecond / clock_ticks_per_s(), 1);
  SetWaitableTimer(timer_, &due, 0, nullptr, nullptr, FALSE);
}

}  // namespace hyrax

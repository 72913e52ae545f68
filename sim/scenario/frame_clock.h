// The dt of every frame, and the time that passes as frames are played.
#pragma once

#include <cassert>
#include <cstdint>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// The clock's base dt in s: 1.0 / rate_hz, or dt_s.
/// REQUIRES: the clock is not a recorded trace.
[[nodiscard]] double base_dt_s(const Clock& clock);

/// One jittered frame. Operations in the order of the format's table, each rounded; + - * and
/// comparison only, so that every machine draws the same bits. At most kFrameMax_s.
[[nodiscard]] double jittered_dt_s(double dt_s, const Jitter& jitter, std::int64_t frame);

/// No frame of the clock is longer, in s: the largest dt that the jitter's rule can give.
/// REQUIRES: the clock is not a recorded trace.
[[nodiscard]] double longest_dt_s(const Clock& clock);

/// Frames to play: `steps`, or ceil(duration_s / dt - 1e-9), or the trace's length.
/// REQUIRES: a duration has a clock of dt > 0. A duration beyond kStepsMax frames gives kStepsMax + 1.
[[nodiscard]] std::int64_t step_count(const ScenarioHead& scenario);

/// dt of frame 0, 1, 2, ... of one clock, before a hitch replaces it. Refers to the clock: it must outlive
/// this.
class FrameClock {
 public:
  explicit FrameClock(const Clock& clock);

  /// Whether every frame has the same dt.
  [[nodiscard]] bool is_fixed() const { return trace_ == nullptr && jitter_ == nullptr; }
  /// dt in s of a frame, the jitter drawn.
  [[nodiscard]] double dt_s(std::int64_t frame) const {
    if (trace_ != nullptr) return (*trace_)[static_cast<std::size_t>(frame)];
    return jitter_ == nullptr ? base_dt_s_ : jittered_dt_s(base_dt_s_, *jitter_, frame);
  }
  /// dt in s that the tolerance of `at_s` is taken from: the base, or the frame's in a trace.
  [[nodiscard]] double nominal_dt_s(std::int64_t frame) const {
    return trace_ != nullptr ? (*trace_)[static_cast<std::size_t>(frame)] : base_dt_s_;
  }

 private:
  double base_dt_s_ = 0.0;
  const Jitter* jitter_ = nullptr;
  const std::vector<double>* trace_ = nullptr;
};

/// Time as frames are played. Frames of bit-equal dt make a segment, within which
/// t = (base + comp) + frames * dt; a finished segment is added to (base, comp) by Neumaier's
/// compensated sum. Source: A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation
/// endlicher Summen", ZAMM 54:39-51, 1974.
struct Timeline {
  double base_s = 0.0;
  double comp_s = 0.0;
  double dt_s = 0.0;        ///< Of the segment's frames.
  std::int64_t frames = 0;  ///< Played in this segment.

  /// Plays `count` frames of dt.
  void play(double frame_dt_s, std::int64_t count = 1) {
    assert(count >= 0);
    if (!same_bits(frame_dt_s, dt_s)) {
      close_segment();
      dt_s = frame_dt_s;
    }
    frames += count;
  }

  /// t in s after `more` further frames of this segment's dt.
  [[nodiscard]] double time_s(std::int64_t more = 0) const {
    return (base_s + comp_s) + static_cast<double>(frames + more) * dt_s;
  }

  bool operator==(const Timeline&) const = default;

 private:
  void close_segment() {
    const double length_s = static_cast<double>(frames) * dt_s;
    const double sum_s = base_s + length_s;
    if (base_s >= length_s)  // Neither is negative.
      comp_s += (base_s - sum_s) + length_s;
    else
      comp_s += (length_s - sum_s) + base_s;
    base_s = sum_s;
    frames = 0;
  }
};

}  // namespace hyrax

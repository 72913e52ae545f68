// The time rule: neither drifting over long runs nor looping over equal frames.
#pragma once

#include <bit>
#include <cstdint>

namespace hyrax {

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
    if (std::bit_cast<std::uint64_t>(frame_dt_s) != std::bit_cast<std::uint64_t>(dt_s)) {
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

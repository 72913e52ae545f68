// The last minutes, kept in memory for whoever asks after the fact.
#pragma once

#include <deque>

#include "tools/hyrax/tape.h"

namespace hyrax {

/// Short tapes, each begun where the one before it ends; the oldest are let go. Five minutes of motion
/// at 60 Hz, in less than a megabyte.
class Ring {
 public:
  static constexpr std::int64_t kTapeFrames = 2048;
  static constexpr std::size_t kTapesMax = 9;

  explicit Ring(const Keyframe& start) { tapes_.emplace_back(start); }

  void add_input(const Action& action) { tapes_.back().add_input(action); }
  /// @param now the state after the frame.
  void add_frame(const Keyframe& now) {
    tapes_.back().add_frame(now.row);
    if (tapes_.back().frames() < kTapeFrames) return;
    tapes_.emplace_back(now);
    if (tapes_.size() > kTapesMax) tapes_.pop_front();
  }

  /// All that is kept, as one.
  [[nodiscard]] Tape tape() const {
    Tape whole = tapes_.front();
    for (std::size_t next = 1; next < tapes_.size(); ++next) whole.append(tapes_[next]);
    return whole;
  }

 private:
  std::deque<Tape> tapes_;
};

}  // namespace hyrax

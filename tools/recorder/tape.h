// Frames as they were shown, and the inputs between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// The dt of each frame, and the hash of all rows, of rows that are packed one behind another, row 0 first:
/// of so many bytes each, the first eight its dt.
[[nodiscard]] RecordedSteps frame_times(std::span<const std::byte> rows, std::size_t row_bytes);
[[nodiscard]] Digest hash_of_rows(std::span<const std::byte> rows, std::size_t row_bytes);

/// Keeps the rows, 41 bytes per frame, so that the hash is that of the frames that were shown.
class Tape {
 public:
  using Start = Keyframe;
  using Input = Action;
  using Document = Scenario;

  /// Begins at a state, with time and step 0.
  explicit Tape(const Keyframe& start);

  /// An input of the next frame.
  void add_input(const Action& action) { inputs_.push_back({frames(), action}); }
  void add_frame(const Row& row);
  [[nodiscard]] std::int64_t frames() const {
    return static_cast<std::int64_t>(rows_.size() / kPackedRowBytes) - 1;
  }

  /// REQUIRES: `next` began where this one ends.
  void append(const Tape& next);

  /// Hash of the rows so far.
  [[nodiscard]] Digest state_hash() const { return hash_of_rows(rows_, kPackedRowBytes); }

  /// The scenario that plays these frames, with their hash in its `expect`. Inputs of the next frame are left
  /// out. REQUIRES: frames() > 0, since a recorded clock cannot be empty.
  [[nodiscard]] Scenario scenario(const std::string& name) const;

 private:
  Keyframe start_;
  std::vector<Event> inputs_;
  std::vector<std::byte> rows_;  // Packed, row 0 first.
};

/// The last five minutes of motion at 60 Hz, in less than 1 MB: short tapes, each of which begins where the
/// one before it ends. The oldest are removed.
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

  /// All frames as one tape.
  [[nodiscard]] Tape tape() const {
    Tape whole = tapes_.front();
    for (std::size_t next = 1; next < tapes_.size(); ++next) whole.append(tapes_[next]);
    return whole;
  }

 private:
  std::deque<Tape> tapes_;
};

}  // namespace hyrax

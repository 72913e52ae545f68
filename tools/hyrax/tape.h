// Frames as they were shown, and the inputs between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// Keeps the rows, 41 bytes a frame, so that the hash it hands on is the hash of what was seen.
class Tape {
 public:
  /// Begins at a state; time and step count from here.
  explicit Tape(const Keyframe& start);

  /// An input of the frame to come.
  void add_input(const Action& action) { inputs_.push_back({frames(), action}); }
  void add_frame(const Row& row);
  [[nodiscard]] std::int64_t frames() const {
    return static_cast<std::int64_t>(rows_.size() / kPackedRowBytes) - 1;
  }

  /// REQUIRES: `next` began where this one ends.
  void append(const Tape& next);

  /// Hash of the rows so far.
  [[nodiscard]] Digest state_hash() const;

  /// The scenario that plays these frames, with their hash in its `expect`. Inputs of a frame that is
  /// yet to come are left out. REQUIRES: frames() > 0, as a clock that is a trace is not empty.
  [[nodiscard]] Scenario scenario(const std::string& name) const;

 private:
  Keyframe start_;
  std::vector<Event> inputs_;
  std::vector<std::byte> rows_;  // Packed, row 0 first.
};

}  // namespace hyrax

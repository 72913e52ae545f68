// The inputs of a run, applied again to the state between two frames.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/schedule.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// What the inputs of one frame did.
struct InputChange {
  bool ends_arc = false;  ///< Every input but a hitch, which is a frame with another dt.
  bool grabs = false;
  bool sets_position = false;
  bool sets_velocity = false;
};

/// Keeps what rows do not say: the sizes in force, and whether the sprite is held.
class InputPlayback {
 public:
  /// @param inputs in order of frames.
  InputPlayback(const Scenario& scenario, std::vector<Input> inputs);

  /// Applies the inputs of frame `row.step`, the frame after the row, to the row's state.
  /// REQUIRES: called for every row in order.
  InputChange apply(Row& row) { return has_inputs_after(row.step) ? apply_due(row) : InputChange{}; }
  [[nodiscard]] bool has_inputs_after(std::int64_t step) const {
    return next_ < inputs_.size() && inputs_[next_].frame <= step;
  }

  [[nodiscard]] bool is_held() const { return world_.is_held; }
  [[nodiscard]] Bounds bounds() const { return world_.bounds(); }

 private:
  InputChange apply_due(Row& row);

  World world_;
  std::vector<Input> inputs_;
  std::size_t next_ = 0;
};

}  // namespace hyrax

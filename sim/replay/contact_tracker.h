// Joins clamped steps to contacts, counts them and hands them on.
#pragma once

#include <array>
#include <cstdint>

#include "sim/trajectory/contact.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

class ContactTracker {
 public:
  /// @param contact_before contact byte of row `step`: its contacts go on without being counted.
  ContactTracker(RowSink& sink, std::uint8_t contact_before, std::int64_t step);

  /// A contact begins at contact.step.
  void begin(const Contact& contact);
  /// The step was clamped by the walls in `contact`.
  void touch(std::uint8_t contact, std::int64_t step) {
    for (const Wall wall : kWalls)
      if (touches(contact, wall)) open_[wall_index(wall)].last_step = step;
  }
  /// Passes over `steps` steps after `step` in which each wall begins `begun` contacts that need
  /// not be handed on; walls that touch at `step` touch at the end as well.
  void pass_over(std::int64_t step, std::int64_t steps, const WallCounts& begun);
  /// Tells the sink how long the last contacts lasted.
  void finish();

  [[nodiscard]] const WallCounts& counts() const { return counts_; }
  /// Whether no further contact will be handed on.
  [[nodiscard]] bool is_full() const { return handed_on_ >= handed_on_max_; }

 private:
  struct Open {
    std::int64_t index = -1;  ///< Among those handed on; -1: none.
    std::int64_t step = 0;
    std::int64_t last_step = -1;
  };
  void end(Open& open);

  RowSink& sink_;
  std::int64_t handed_on_max_;
  std::int64_t handed_on_ = 0;
  std::array<Open, 4> open_;
  WallCounts counts_{};
};

}  // namespace hyrax

// Counts contacts and hands them on.
#pragma once

#include <array>
#include <cstdint>

#include "sim/trajectory/contact.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

class ContactTracker {
 public:
  explicit ContactTracker(RowSink& sink);

  /// A contact begins at contact.step.
  void begin(const Contact& contact);
  /// The wall clamped for the last time at `last_step`.
  void end(Wall wall, std::int64_t last_step);
  /// Counts contacts that need not be handed on. REQUIRES: is_full(), or there are none.
  void count(const WallCounts& begun);
  /// The run ends at `last_step`, and with it the contacts that go on.
  void finish(std::int64_t last_step);

  [[nodiscard]] const WallCounts& counts() const { return counts_; }
  /// Whether no further contact will be handed on.
  [[nodiscard]] bool is_full() const { return handed_on_ >= handed_on_max_; }

 private:
  static constexpr std::int64_t kNone = -1;
  struct Open {
    std::int64_t index = kNone;  ///< Among those handed on.
    std::int64_t step = 0;
  };

  RowSink& sink_;
  std::int64_t handed_on_max_;
  std::int64_t handed_on_ = 0;
  std::array<Open, 4> open_;
  WallCounts counts_{};
};

}  // namespace hyrax

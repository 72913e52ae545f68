// Counts contacts and passes them to the sinks that want them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/trajectory/contact.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

class ContactTracker {
 public:
  /// Refers to the sinks.
  explicit ContactTracker(std::span<RowSink* const> sinks);

  /// A contact begins at contact.step.
  void begin(const Contact& contact);
  /// The wall clamped for the last time at `last_step`.
  void end(Wall wall, std::int64_t last_step);
  /// Counts contacts that need not be passed on. REQUIRES: is_full(), or there are none.
  void count(const WallCounts& begun);
  /// The run ends at `last_step`, and with it the contacts that go on.
  void finish(std::int64_t last_step);

  [[nodiscard]] const WallCounts& counts() const { return counts_; }
  /// Whether no further contact will be passed on.
  [[nodiscard]] bool is_full() const { return passed_ >= passed_max_; }

 private:
  static constexpr std::int64_t kNone = -1;
  struct Open {
    std::int64_t index = kNone;  ///< Among those passed on.
    std::int64_t step = 0;
  };

  std::vector<RowSink*> sinks_;
  std::int64_t passed_max_;
  std::int64_t passed_ = 0;
  std::array<Open, 4> open_;
  WallCounts counts_{};
};

}  // namespace hyrax

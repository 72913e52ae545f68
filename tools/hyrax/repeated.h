// What is done several times a second.
#pragma once

#include <cstdint>

namespace hyrax {

/// Due at first, and again a period after it was last done.
class Repeated {
 public:
  Repeated(std::int64_t ticks_per_s, std::int64_t times_per_s) : period_ticks_(ticks_per_s / times_per_s) {}

  [[nodiscard]] bool is_due(std::int64_t now_ticks) const { return now_ticks >= due_ticks_; }
  void done(std::int64_t now_ticks) { due_ticks_ = now_ticks + period_ticks_; }

 private:
  std::int64_t period_ticks_;
  std::int64_t due_ticks_ = 0;
};

}  // namespace hyrax

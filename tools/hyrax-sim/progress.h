// A line on a terminal that tells how far long work has come.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace hyrax {

/// Shown on stderr where that is a terminal, after half a second, with rate and time left; wiped
/// away at the end.
class Progress {
 public:
  Progress(std::string unit, std::int64_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  [[nodiscard]] bool is_shown() const { return is_terminal_; }
  void show(std::int64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string unit_;
  std::int64_t total_;
  bool is_terminal_;
  bool has_line_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
};

}  // namespace hyrax

// Progress of long work, on a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace hyrax {

/// "3 of 12 steps, 1.5 per second, 6 s left"; rate and time left only once something is done.
[[nodiscard]] std::string progress_text(std::int64_t done, std::int64_t total, const std::string& unit,
                                        double elapsed_s);

/// A line on stderr if that is a terminal, after half a second, with rate and time left; erased at the end.
/// The time left is right if all units take about the same time.
class Progress {
 public:
  Progress(std::string unit, std::int64_t total);
  /// For show_text.
  Progress() : Progress("", 0) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  [[nodiscard]] bool is_shown() const { return is_terminal_; }
  void show(std::int64_t done);
  /// Any other text, for work without a known total.
  void show_text(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due();
  void print(const std::string& text);

  std::string unit_;
  std::int64_t total_;
  bool is_terminal_;
  bool has_line_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
};

}  // namespace hyrax

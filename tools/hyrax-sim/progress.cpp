#include "tools/hyrax-sim/progress.h"

#include <fmt/format.h>

#include <cstdio>

#include <unistd.h>

namespace hyrax {

Progress::Progress(std::string unit, std::int64_t total)
    : unit_(std::move(unit)), total_(total), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (has_line_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::int64_t done) {
  using std::chrono::duration;
  const Clock::time_point now = Clock::now();
  const double elapsed_s = duration<double>(now - start_).count();
  if (!is_terminal_ || elapsed_s < 0.5 || duration<double>(now - last_shown_).count() < 0.1) return;
  last_shown_ = now;
  has_line_ = true;
  const double rate = static_cast<double>(done) / elapsed_s;
  const double left_s = static_cast<double>(total_ - done) / rate;
  // Unlike fmt::print, this ends nothing where the terminal is gone.
  std::fputs(
      fmt::format("\r\x1b[K{} of {} {}, {:.3g} per second, {:.0f} s left", done, total_, unit_, rate, left_s)
          .c_str(),
      stderr);
  std::fflush(stderr);
}

}  // namespace hyrax

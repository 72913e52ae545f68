#include "tools/app/command_line/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tools/platform/standard_streams.h"

namespace hyrax {

std::string progress_text(std::int64_t done, std::int64_t total, const std::string& unit, double elapsed_s) {
  const std::string text = fmt::format("{} of {} {}", done, total, unit);
  if (done <= 0 || elapsed_s <= 0.0) return text;
  const double rate = static_cast<double>(done) / elapsed_s;
  return text + fmt::format(", {:.3g} per second, {:.0f} s left", rate,
                            static_cast<double>(std::max<std::int64_t>(total - done, 0)) / rate);
}

Progress::Progress(std::string unit, std::int64_t total)
    : unit_(std::move(unit)), total_(total), is_terminal_(hyrax::is_terminal(stderr)) {}

Progress::~Progress() {
  if (has_line_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::int64_t done) {
  if (is_due())
    print(progress_text(done, total_, unit_, std::chrono::duration<double>(last_shown_ - start_).count()));
}

void Progress::show_text(const std::string& text) {
  if (is_due()) print(text);
}

bool Progress::is_due() {
  using std::chrono::duration;
  const Clock::time_point now = Clock::now();
  if (!is_terminal_ || duration<double>(now - start_).count() < 0.5 ||
      duration<double>(now - last_shown_).count() < 0.1)
    return false;
  last_shown_ = now;
  return true;
}

void Progress::print(const std::string& text) {
  has_line_ = true;
  // Unlike fmt::print, this throws nothing if the terminal was closed.
  std::fputs(("\r\x1b[K" + text).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace hyrax

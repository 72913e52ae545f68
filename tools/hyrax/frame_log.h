// A log of the frames that were shown, one line of JSON per frame, for tests and debugging.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "sim/trajectory/row.h"
#include "tools/hyrax/desk.h"

namespace hyrax {

/// Sides of a rectangle of the screen, px; right and bottom are the first px outside.
struct ScreenRect {
  std::int32_t left_px = 0;
  std::int32_t top_px = 0;
  std::int32_t right_px = 0;
  std::int32_t bottom_px = 0;
};

class FrameLog {
 public:
  /// ERRORS: Failure(bad_input) if the file exists; Failure(cannot_access) "PATH: cannot be written: REASON".
  explicit FrameLog(const std::string& path);

  /// A frame, its inputs, and the position of the window as the system reports it:
  /// {"frame", "t_s", "dt_s", "x_px", "y_px", "vx_px_per_s", "vy_px_per_s", "held", "window_rect_px": [left,
  /// top, right, bottom], "work_area_px": [left, top, right, bottom], "sprite_px": [width, height],
  /// "inputs": [NAME...]}.
  void frame(const Keyframe& now, const Desk& desk, const std::vector<Action>& inputs,
             const ScreenRect& window);
  /// {"asleep_after_frame": FRAME}.
  void sleep(const Keyframe& now);
  /// ERRORS: Failure(cannot_access) as above if a line could not be written; none was after it.
  void finish() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void line(const std::string& text);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  int error_ = 0;  // Of the first line that could not be written.
};

}  // namespace hyrax

// Recorded frame times, from a CSV file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hyrax {

/// Empty texts: not given. Names of columns, and what is picked, are compared without case and blanks.
struct FrameTimesRequest {
  std::string path;
  std::string column;  ///< Default: PresentMon's, MsBetweenPresents (version 1) or FrameTime (version 2).
  std::string unit;    ///< "s" or "ms". Default for PresentMon's columns: what a column fps says, else ms.
  std::string application;
  std::string process;
  std::string swap_chain;
  bool operator==(const FrameTimesRequest&) const = default;
};

struct FrameTimes {
  std::vector<double> dt_s;
  std::optional<std::int64_t> dropped;  ///< Frames that were never displayed, if the file says so.
  /// Rows of another FrameType than Application, as generated frames have: they are no frames here.
  std::optional<std::int64_t> left_out;
  std::string unit;   ///< "s", "ms" or "us", as they were read.
  std::string doubt;  ///< A sentence, if half of the frames are too long or too short for a display.
};

/// Frames of one application, process and swap chain; a frame that was dropped is one too. Reads the CSV
/// files of PresentMon, FrameView, OCAT, CapFrameX and MangoHud, and any other with a column of frame times.
/// ERRORS: Failure(cannot_access); Failure(bad_input) "PATH: line 2, column 3 (NAME): ...", also if frames of
/// several remain.
[[nodiscard]] FrameTimes read_frame_times(const FrameTimesRequest& request);

}  // namespace hyrax

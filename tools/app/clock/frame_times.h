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
  std::string unit;    ///< "s" or "ms", the default for PresentMon's columns.
  std::string application;
  std::string process;
  std::string swap_chain;
  bool operator==(const FrameTimesRequest&) const = default;
};

struct FrameTimes {
  std::vector<double> dt_s;
  std::optional<std::int64_t> dropped;  ///< Frames that were never displayed, if the file says so.
};

/// Frames of one application, process and swap chain; a frame that was dropped is one too.
/// ERRORS: Failure(cannot_access); Failure(bad_input) "PATH: line 2, column 3 (NAME): ...", also if frames of
/// several remain.
[[nodiscard]] FrameTimes read_frame_times(const FrameTimesRequest& request);

}  // namespace hyrax

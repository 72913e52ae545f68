// Writes a scenario to start from: what the command new does for any core.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/app/command_line/options.h"

namespace hyrax {

// Recorded frame times, from a CSV file.

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

struct NewRequest {
  std::vector<std::string> names = {};
  std::string core = {};  ///< A header to write instead; only hyrax-sim itself has the option.
  FrameTimesRequest clock = {};
  bool is_forced = false;
  Printing printing = {};
};

/// @param least of names.
void declare_new(Options& options, NewRequest& request, int least = 1);

/// Writes NAME.json.
/// @param document with a clock of its own, and its steps; an event at most, which the clock must reach.
/// @param read throws where the document is no scenario.
/// ERRORS: Failure(bad_input) also if the file exists and is not to be replaced.
[[nodiscard]] ExitCode write_new(const NewRequest& request, Json document,
                                 const std::function<void(const Json&, const std::string& path)>& read);

}  // namespace hyrax

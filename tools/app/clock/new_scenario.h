// Writes a scenario to start from: what the command new does for any core.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/app/clock/frame_times.h"
#include "tools/app/command_line/options.h"

namespace hyrax {

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

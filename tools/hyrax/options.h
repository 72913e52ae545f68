// The command line of hyrax.exe.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hyrax {

struct PetOptions {
  std::optional<std::string> record_path;  ///< Record from start to end.
  std::optional<std::string> replay_path;  ///< Play this scenario, then end.
  std::optional<std::string> log_path;     ///< One line per frame.
  std::optional<double> seconds;           ///< End after so many; >= 0.
  bool only_exits = false;                 ///< With a replay: no window, only the exit code.
  bool wants_help = false;
  bool wants_version = false;
};

/// ERRORS: Failure(bad_input) that names the option, the value and the rule.
[[nodiscard]] PetOptions parse_options(const std::vector<std::string>& arguments);

}  // namespace hyrax

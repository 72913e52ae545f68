// Suggested commands.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// A command line that can be pasted into a POSIX shell: the words, quoted where they have to be. A word
/// with control characters or bytes outside of ASCII that are no UTF-8 takes the form $'...', which bash, zsh
/// and POSIX 2024 read; nothing of it reaches a terminal raw.
[[nodiscard]] std::string shell_command(const std::vector<std::string>& words);

/// The same path, written so that no command takes it for an option.
[[nodiscard]] std::string as_argument(const std::string& path);

/// The command that blesses a scenario: with the --golden it was looked for in, where its own path does not
/// lead there, or with `--golden golden` where nothing leads to a place.
/// @param golden_folder as given; empty where it was not.
[[nodiscard]] std::string bless_command_for(const std::string& scenario_path,
                                            const std::string& golden_folder);

}  // namespace hyrax

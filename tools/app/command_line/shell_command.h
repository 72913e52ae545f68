// Suggested commands.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// A command line that can be pasted into a POSIX shell: the arguments, quoted where necessary. An argument
/// with control characters or invalid UTF-8 takes the form $'...', which bash, zsh and POSIX 2024 read; no
/// control character of it is printed as such.
[[nodiscard]] std::string shell_command(const std::vector<std::string>& arguments);

/// Names this program in suggested commands and messages as it was called, which matters where it is not
/// `hyrax-sim`: a program with a core of one's own. At start, before any other function here.
void set_program(const std::string& as_called);

/// shell_command of this program with these arguments.
[[nodiscard]] std::string program_command(std::vector<std::string> arguments);

/// The same path in a form that is not parsed as an option.
[[nodiscard]] std::string as_argument(const std::string& path);

/// The commands that play a scenario, and compare its run with its golden file.
[[nodiscard]] std::string diff_commands(const std::string& scenario_path, const std::string& h5_path);

/// The command that blesses scenarios or folders of them, with --golden if the path of the first alone does
/// not lead to the golden file: the folder that was given, or `golden`. REQUIRES: at least one path.
/// @param golden_folder as given; empty if it was not.
[[nodiscard]] std::string bless_command_for(const std::vector<std::string>& paths,
                                            const std::string& golden_folder);

}  // namespace hyrax

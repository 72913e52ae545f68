// A program of commands: its help, its exit codes, and what it needs before the first of them runs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/app/command_line/options.h"

namespace hyrax {

using CommandAct = std::function<ExitCode(const Core& core)>;

struct CommandProgram {
  std::vector<Command> commands = {};
  std::string first_screen = {};
  /// Throws a Failure where the program's core does not allow the command. @param name as "hyrax-sim run".
  std::function<void(const Command& command, const std::string& name)> require = {};
  /// Runs a command with the program's core.
  std::function<ExitCode(const CommandAct& act)> act = {};
  /// Not hyrax-sim itself: messages and suggested commands have the name by which it was called.
  bool is_own = false;
};

/// What `main` returns, with its arguments.
[[nodiscard]] int run_commands(const CommandProgram& program, int argc, char** argv);

/// How a first screen ends: usage, the common commands, the others, options, exit codes.
/// @param applies of which commands it has.
[[nodiscard]] std::string command_lists(const std::vector<Command>& commands,
                                        const std::function<bool(const Command&)>& applies);

}  // namespace hyrax

#include "tools/app/command_line/command_program.h"

#include <filesystem>

#include "sim/physics/strict_arithmetic.h"
#include "tools/app/command_line/print.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/build_info.h"
#include "tools/files/main_program.h"
#include "tools/files/unknown_word.h"
#include "tools/platform/process.h"
#include "tools/platform/standard_streams.h"

namespace hyrax {
namespace {

ExitCode print_help(const std::string& text) {
  print_text(with_own_name(text));
  return ExitCode::agreed;
}

const Command& find(const std::vector<Command>& commands, const std::string& name) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) {
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  refuse_usage("hyrax-sim", unknown_word("command", name, names));
}

ExitCode run_command_line(const CommandProgram& program, std::vector<std::string> arguments) {
  if (arguments.size() > 1 && arguments.front() == "help") arguments = {arguments[1], "--help"};
  const std::string name = arguments.empty() ? "--help" : arguments.front();
  if (name == "--help" || name == "-h" || name == "help") return print_help(program.first_screen);
  if (name == "--version" || name == "-V") {
    print_text("hyrax-sim {}\n", build_info().version);
    return ExitCode::agreed;
  }
  const Command& command = find(program.commands, name);
  const std::string command_name = "hyrax-sim " + name;
  program.require(command, command_name);
  Options options;
  const CommandAct act = command.declare(options);
  if (!options.parse(command_name, {arguments.begin() + 1, arguments.end()}))
    return print_help(command.summary + "\n" + options.help(command_name) + "\nExample:\n  " +
                      command.example + "\n");
  if (command.needs_strict_ieee)
    if (const auto fault = arithmetic_fault())
      throw Failure(ExitCode::not_strict_ieee, "hyrax-sim: " + std::string(*fault));
  return program.act(act);
}

std::string command_list(const std::vector<Command>& commands, bool is_common,
                         const std::function<bool(const Command&)>& applies) {
  std::string text;
  for (const Command& command : commands)
    if (command.is_common == is_common && applies(command))
      text += fmt::format("  {:<9} {}\n", command.name, command.summary);
  return text;
}

}  // namespace

std::string command_lists(const std::vector<Command>& commands,
                          const std::function<bool(const Command&)>& applies) {
  return "Usage: hyrax-sim COMMAND [OPTION]... [FILE]...\n\n"
         "Commands:\n" +
         command_list(commands, true, applies) + "\nMore:\n" + command_list(commands, false, applies) +
         "\n`hyrax-sim COMMAND --help` describes a command, with an example; `--version` (`-V`) "
         "prints the version.\n"
         "Exit codes: 0 agreed or done, 1 disagreed, 2 bad usage or input, 3 cannot read or write,\n"
         "4 golden file missing (or a part of a sweep), 5 arithmetic is not strict IEEE-754, 70 internal "
         "error.\n";
}

int run_commands(const CommandProgram& program, int argc, char** argv) {
  prepare_standard_streams();
  prepare_signals();
  return run_program("hyrax-sim", argc, argv, [&](const std::vector<std::string>& arguments) {
    if (argc > 0 && program.is_own) set_program(argv[0]);
    try {
      return run_command_line(program, arguments);
    } catch (const std::filesystem::filesystem_error& error) {
      throw Failure(ExitCode::cannot_access,
                    error.path1().string() + ": cannot be accessed: " + error.code().message());
    }
  });
}

}  // namespace hyrax

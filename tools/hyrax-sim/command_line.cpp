#include "sim/physics/strict_arithmetic.h"
#include "tools/files/build_info.h"
#include "tools/files/printable.h"
#include "tools/files/unknown_word.h"
#include "tools/hyrax-sim/options.h"

namespace hyrax {
namespace {

std::string command_list(const std::vector<Command>& commands, bool is_common) {
  std::string text;
  for (const Command& command : commands) {
    if (command.is_common != is_common) continue;
    text += "  " + command.name + std::string(command.name.size() < 10 ? 10 - command.name.size() : 1, ' ') +
            command.summary + "\n";
  }
  return text;
}

std::string first_screen(const std::vector<Command>& commands) {
  return "hyrax-sim replays flings of the hyrax bit for bit, and reports what changed and how exact they "
         "are.\n\n"
         "  hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
         "  hyrax-sim check\n\n"
         "Usage: hyrax-sim COMMAND [OPTION]... [FILE]...\n\n"
         "Commands:\n" +
         command_list(commands, true) + "\nMore:\n" + command_list(commands, false) +
         "\n`hyrax-sim COMMAND --help` describes a command, with an example; `--version` (`-V`) "
         "prints the version.\n"
         "Exit codes: 0 agreed or done, 1 disagreed, 2 bad usage or input, 3 cannot read or write,\n"
         "4 golden file missing, 5 arithmetic is not strict IEEE-754, 70 internal error.\n";
}

const Command* find(const std::vector<Command>& commands, const std::string& name) {
  for (const Command& command : commands)
    if (command.name == name) return &command;
  return nullptr;
}

std::vector<std::string_view> names_of(const std::vector<Command>& commands) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

void require_strict_ieee() {
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax-sim: " + std::string(*fault));
}

ExitCode print_help(const std::string& text) {
  print_text(text);
  return ExitCode::agreed;
}

[[noreturn]] void refuse(const std::string& command, const std::string& what) {
  throw Failure(ExitCode::bad_input, command + ": " + what + "; see `" + command + " --help`");
}

}  // namespace

ExitCode run_command_line(const std::vector<std::string>& arguments, const std::vector<Command>& commands) {
  const std::string name = arguments.empty() ? "--help" : arguments.front();
  if (name == "--help" || name == "-h" || name == "help") return print_help(first_screen(commands));
  if (name == "--version" || name == "-V")
    return print_help("hyrax-sim " + std::string(build_info().version) + "\n");
  const Command* const command = find(commands, name);
  if (command == nullptr) refuse("hyrax-sim", unknown_word("command", name, names_of(commands)));

  Options options;
  const std::function<ExitCode()> act = command->declare(options);
  try {
    if (!options.parse({arguments.begin() + 1, arguments.end()}))
      return print_help(command->summary + "\n" + options.help(name) + "\nExample:\n  " + command->example +
                        "\n");
  } catch (const Failure& failure) {
    refuse("hyrax-sim " + name, failure.what());
  }
  if (command->needs_strict_ieee) require_strict_ieee();
  return act();
}

}  // namespace hyrax

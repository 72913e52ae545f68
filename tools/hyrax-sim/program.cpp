#include "tools/hyrax-sim/program.h"

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "sim/physics/strict_arithmetic.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/print.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/core/paper_model.h"
#include "tools/files/build_info.h"
#include "tools/files/main_program.h"
#include "tools/files/unknown_word.h"

// All commands, in the order of the help. NAME.cpp defines NAME_command().
#define HYRAX_COMMANDS(COMMAND) \
  COMMAND(run)                  \
  COMMAND(check)                \
  COMMAND(bless)                \
  COMMAND(diff)                 \
  COMMAND(drift)                \
  COMMAND(study)                \
  COMMAND(sweep)                \
  COMMAND(report)               \
  COMMAND(new)                  \
  COMMAND(fuzz)                 \
  COMMAND(shrink)               \
  COMMAND(validate)             \
  COMMAND(schema)               \
  COMMAND(info)

namespace hyrax {

#define HYRAX_DECLARE(name) Command name##_command();
HYRAX_COMMANDS(HYRAX_DECLARE)

namespace {

std::vector<Command> all_commands() {
#define HYRAX_CALL(name) name##_command(),
  return {HYRAX_COMMANDS(HYRAX_CALL)};
}

// To this program's core.
bool applies(const Core& core, const Command& command) { return !command.needs_paper_step || core.constants; }

std::string command_list(const Core& core, const std::vector<Command>& commands, bool is_common) {
  std::string text;
  for (const Command& command : commands)
    if (command.is_common == is_common && applies(core, command))
      text += fmt::format("  {:<9} {}\n", command.name, command.summary);
  return text;
}

// Says what this program is, if it is not the one that the help is about.
std::string about_core(const Core& core) {
  if (is_paper_model(core.name)) return "";
  return fmt::format("This program's core is {}{}.\n\n", core.name,
                     core.constants ? ", the paper's step with constants of its own"
                                    : ", not the paper's step: commands that need it are left out");
}

std::string first_screen(const Core& core, const std::vector<Command>& commands) {
  return "hyrax-sim replays flings of the hyrax bit for bit, and reports what changed and how large the "
         "errors are.\n\n" +
         about_core(core) +
         "  hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
         "  hyrax-sim check\n\n"
         "Usage: hyrax-sim COMMAND [OPTION]... [FILE]...\n\n"
         "Commands:\n" +
         command_list(core, commands, true) + "\nMore:\n" + command_list(core, commands, false) +
         "\n`hyrax-sim COMMAND --help` describes a command, with an example; `--version` (`-V`) "
         "prints the version.\n"
         "Exit codes: 0 agreed or done, 1 disagreed, 2 bad usage or input, 3 cannot read or write,\n"
         "4 golden file missing (or a part of a sweep), 5 arithmetic is not strict IEEE-754, 70 internal "
         "error.\n";
}

ExitCode print_help(const std::string& text) {
  print_text(text);
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

ExitCode run_command_line(const Core& core, std::vector<std::string> arguments) {
  const std::vector<Command> commands = all_commands();
  if (arguments.size() > 1 && arguments.front() == "help") arguments = {arguments[1], "--help"};
  const std::string name = arguments.empty() ? "--help" : arguments.front();
  if (name == "--help" || name == "-h" || name == "help") return print_help(first_screen(core, commands));
  if (name == "--version" || name == "-V")
    return print_help("hyrax-sim " + std::string(build_info().version) + "\n");
  const Command& command = find(commands, name);
  const std::string command_name = "hyrax-sim " + name;
  if (command.needs_paper_step) require_paper_core(core, command_name);
  Options options;
  const std::function<ExitCode(const Core&)> act = command.declare(options);
  if (!options.parse(command_name, {arguments.begin() + 1, arguments.end()}))
    return print_help(command.summary + "\n" + options.help(command_name) + "\nExample:\n  " +
                      command.example + "\n");
  if (command.needs_strict_ieee)
    if (const auto fault = arithmetic_fault())
      throw Failure(ExitCode::not_strict_ieee, "hyrax-sim: " + std::string(*fault));
  return act(core);
}

// Otherwise the first file that is opened would get the number of a closed stream, and be printed into.
// Writing to a stream that is open for reading only fails, as writing to a closed one does.
void open_closed_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
}

}  // namespace

int run_hyrax_sim(const Core& core, int argc, char** argv) {
  open_closed_streams();
  // A file that may not grow further is an error like a full disk; it does not end the process.
  std::signal(SIGXFSZ, SIG_IGN);
  // If a parent process left it ignored, the exit status of a child process would be lost.
  std::signal(SIGCHLD, SIG_DFL);
  return run_program("hyrax-sim", argc, argv, [&](const std::vector<std::string>& arguments) {
    if (argc > 0 && !is_paper_model(core.name)) set_program(argv[0]);
    try {
      return run_command_line(core, arguments);
    } catch (const std::filesystem::filesystem_error& error) {
      throw Failure(ExitCode::cannot_access,
                    error.path1().string() + ": cannot be accessed: " + error.code().message());
    }
  });
}

}  // namespace hyrax

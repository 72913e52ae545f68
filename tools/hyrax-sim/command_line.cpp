#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

#include "sim/physics/strict_arithmetic.h"
#include "tools/files/build_info.h"
#include "tools/hyrax-sim/options.h"

namespace hyrax {
namespace {

class CliOptions : public Options {
 public:
  explicit CliOptions(CLI::App& app) : app_(app) {}

  void files(std::vector<std::string>& into, const OptionText& text, int least, int most) override {
    app_.add_option(text.names, into, text.help)->type_name("")->expected(least, most)->required(least > 0);
  }
  void flag(bool& into, const OptionText& text) override { app_.add_flag(text.names, into, text.help); }
  void text(std::string& into, const OptionText& text) override {
    app_.add_option(text.names, into, text.help)->type_name(text.value);
  }
  void texts(std::vector<std::string>& into, const OptionText& text) override {
    app_.add_option(text.names, into, text.help)->type_name(text.value)->expected(1)->take_all();
  }
  void number(std::optional<double>& into, const OptionText& text, double low) override {
    add_checked(
        into, text, [low](double value) { return std::isfinite(value) && value >= low; },
        "must be a number of at least " + CLI::detail::to_string(low));
  }
  void whole(std::optional<std::int64_t>& into, const OptionText& text, std::int64_t low) override {
    add_checked(
        into, text, [low](std::int64_t value) { return value >= low; },
        "must be a whole number of at least " + std::to_string(low));
  }
  void choice(std::string& into, const OptionText& text, const std::vector<std::string>& words) override {
    app_.add_option(text.names, into, text.help)->type_name(text.value)->check(CLI::IsMember(words));
  }

 private:
  template <class Value, class Holds>
  void add_checked(std::optional<Value>& into, const OptionText& text, const Holds& holds,
                   const std::string& rule) {
    const auto take = [&into, holds, rule, names = text.names](const Value& value) {
      if (!holds(value)) throw CLI::ValidationError(names, rule);
      into = value;
    };
    app_.add_option_function<Value>(text.names, take, text.help)->type_name(text.value);
  }

  CLI::App& app_;
};

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
  return "hyrax-sim replays flings of the hyrax bit for bit, and tells what changed and how exact they "
         "are.\n\n"
         "  hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
         "  hyrax-sim check\n\n"
         "Usage: hyrax-sim COMMAND [OPTION]... [FILE]...\n\n"
         "Commands:\n" +
         command_list(commands, true) + "\nMore:\n" + command_list(commands, false) +
         "\n`hyrax-sim COMMAND --help` tells all about one, with an example; `--version` the version.\n"
         "Exit codes: 0 agreed or done, 1 disagreed, 2 bad usage or input, 3 cannot read or write,\n"
         "4 golden file missing, 5 this machine or build does no strict IEEE-754 arithmetic, 70 own fault.\n";
}

const Command* find(const std::vector<Command>& commands, const std::string& name) {
  for (const Command& command : commands)
    if (command.name == name) return &command;
  return nullptr;
}

void require_strict_ieee() {
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax-sim: " + std::string(*fault));
}

ExitCode print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return ExitCode::agreed;
}

}  // namespace

ExitCode run_command_line(const std::vector<std::string>& arguments, const std::vector<Command>& commands) {
  const std::string name = arguments.empty() ? "--help" : arguments.front();
  if (name == "--help" || name == "-h" || name == "help") return print(first_screen(commands));
  if (name == "--version") return print("hyrax-sim " + std::string(build_info().version) + "\n");
  const Command* const command = find(commands, name);
  if (command == nullptr)
    throw Failure(ExitCode::bad_input,
                  "hyrax-sim: '" + name + "' is no command; `hyrax-sim --help` lists them");

  CLI::App app(command->summary, "hyrax-sim " + command->name);
  app.footer("Example:\n  " + command->example);
  CliOptions options(app);
  const std::function<ExitCode()> act = command->declare(options);
  try {
    // CLI11 takes them from the back.
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::CallForHelp&) {
    return print(app.help());
  } catch (const CLI::ParseError& error) {
    throw Failure(ExitCode::bad_input, "hyrax-sim " + command->name + ": " + error.what() + "; `hyrax-sim " +
                                           command->name + " --help` tells what may stand");
  }
  if (command->needs_strict_ieee) require_strict_ieee();
  return act();
}

}  // namespace hyrax

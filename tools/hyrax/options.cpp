#include "tools/hyrax/options.h"

#include <cstdlib>
#include <set>

#include "tools/files/failure.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  refuse_input("hyrax: " + sentence + "; see `hyrax --help`");
}

double seconds_of(const std::string& text) {
  constexpr double kSecondsMax = 1e9;
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(seconds >= 0.0 && seconds <= kSecondsMax))
    refuse("--seconds must be a number 0 .. 1e9 (found " + text + ")");
  return seconds;
}

}  // namespace

PetOptions parse_options(const std::vector<std::string>& arguments) {
  PetOptions options;
  std::set<std::string> given_options;
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const std::size_t equals = argument->starts_with("--") ? argument->find('=') : std::string::npos;
    const bool is_file = !argument->empty() && argument->front() != '-' && *argument != "/?";
    const std::string option = is_file ? "--replay" : argument->substr(0, equals);
    if (!given_options.insert(option).second) refuse(option + ": given twice");
    std::optional<std::string> given;  // The value, after `=` or as the next argument; a file is one.
    if (is_file) given = *argument;
    if (equals != std::string::npos) given = argument->substr(equals + 1);
    const auto value = [&] {
      if (!given && argument + 1 != arguments.end()) given = *++argument;
      if (!given || given->empty()) refuse(option + " needs a value");
      return *given;
    };
    const auto flag = [&] {
      if (given) refuse(option + " takes no value (found " + *given + ")");
      return true;
    };
    if (option == "--record")
      options.record_path = value();
    else if (option == "--replay")
      options.replay_path = value();
    else if (option == "--log")
      options.log_path = value();
    else if (option == "--seconds")
      options.seconds = seconds_of(value());
    else if (option == "--exit")
      options.only_exits = flag();
    else if (option == "--help" || option == "-h" || option == "/?")
      options.wants_help = flag();
    else if (option == "--version")
      options.wants_version = flag();
    else
      refuse(unknown_word("option", option,
                          {"--record", "--replay", "--log", "--seconds", "--exit", "--help", "--version"}));
  }
  if (options.only_exits && !options.replay_path) refuse("--exit needs --replay FILE");
  if (options.only_exits && (options.log_path || options.seconds))
    refuse("--exit is not allowed with --log or --seconds: no frame is shown");
  if (options.record_path && options.record_path == options.log_path)
    refuse("--record and --log need different files (found " + *options.log_path + ")");
  if (options.record_path && options.replay_path)
    refuse("--record is not allowed with --replay: a replay is recorded already");
  return options;
}

}  // namespace hyrax

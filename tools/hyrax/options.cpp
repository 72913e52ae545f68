#include "tools/hyrax/options.h"

#include <cstdlib>

#include "help_text.h"
#include "tools/files/failure.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  throw Failure(ExitCode::bad_input, "hyrax: " + sentence + "; see `hyrax --help`");
}

// Reads the arguments one by one; a value follows its option, as the next argument or after `=`.
class Arguments {
 public:
  explicit Arguments(const std::vector<std::string>& arguments) : arguments_(arguments) {}

  bool next() {
    if (++at_ > arguments_.size()) return false;
    const std::string& argument = arguments_[at_ - 1];
    const std::size_t equals = argument.starts_with("--") ? argument.find('=') : std::string::npos;
    option_ = argument.substr(0, equals);
    value_.reset();
    if (equals != std::string::npos) value_ = argument.substr(equals + 1);
    return true;
  }
  const std::string& option() const { return option_; }
  std::string value() {
    if (!value_ && at_ < arguments_.size()) value_ = arguments_[at_++];
    if (!value_ || value_->empty()) refuse(option_ + " needs a value");
    return *value_;
  }
  bool flag() const {
    if (value_) refuse(option_ + " takes no value (found " + *value_ + ")");
    return true;
  }

 private:
  const std::vector<std::string>& arguments_;
  std::size_t at_ = 0;
  std::string option_;
  std::optional<std::string> value_;
};

double seconds_of(const std::string& text) {
  constexpr double kSecondsMax = 1e9;
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !(seconds >= 0.0 && seconds <= kSecondsMax))
    refuse("--seconds must be a number 0 .. 1e9 (found " + text + ")");
  return seconds;
}

void check(const PetOptions& options) {
  if (options.only_exits && !options.replay_path) refuse("--exit needs --replay FILE");
  if (options.record_path && options.replay_path)
    refuse("--record is not allowed with --replay: a replay is recorded already");
}

}  // namespace

PetOptions parse_options(const std::vector<std::string>& arguments) {
  PetOptions options;
  for (Arguments given(arguments); given.next();) {
    const std::string& option = given.option();
    if (option == "--record")
      options.record_path = given.value();
    else if (option == "--replay")
      options.replay_path = given.value();
    else if (option == "--log")
      options.log_path = given.value();
    else if (option == "--seconds")
      options.seconds = seconds_of(given.value());
    else if (option == "--exit")
      options.only_exits = given.flag();
    else if (option == "--help" || option == "-h")
      options.wants_help = given.flag();
    else if (option == "--version")
      options.wants_version = given.flag();
    else
      refuse(unknown_word("option", option,
                          {"--record", "--replay", "--log", "--seconds", "--exit", "--help", "--version"}));
  }
  check(options);
  return options;
}

std::string_view help_text() { return kHelpText; }

}  // namespace hyrax

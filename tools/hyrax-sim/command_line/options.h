// How a command declares its arguments, and how they are read from the command line.
//
// Libraries were tried: CLI11 splits a file named `[a,b]` into two and lets an option with several values
// take the files after it; getopt_long accepts abbreviations, which a later option makes ambiguous.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

/// An option's names, as "-o,--output", what its value is called, and what it does.
struct OptionText {
  std::string names;
  std::string value;
  std::string help;
};

/// Every argument is taken literally: nothing is split, unquoted or expanded. An option takes its value from
/// `--name=VALUE`, `-nVALUE` or the next argument, whatever that looks like; after `--` all arguments are
/// files.
class Options {
 public:
  /// Arguments without an option name: at least `least` and at most `most`; most = -1: any number.
  void files(std::vector<std::string>& into, const OptionText& text, int least, int most);
  void flag(bool& into, const OptionText& text);
  void text(std::string& into, const OptionText& text);
  /// May be given several times, a value each.
  void texts(std::vector<std::string>& into, const OptionText& text);
  /// A finite number, at least `low`.
  void number(std::optional<double>& into, const OptionText& text, double low);
  /// A whole number, at least `low`.
  void whole(std::optional<std::int64_t>& into, const OptionText& text, std::int64_t low);
  /// One of `words`.
  void choice(std::string& into, const OptionText& text, const std::vector<std::string>& words);

  /// Fills what was declared. Returns false where help is asked for: then nothing is complete.
  /// ERRORS: Failure(bad_input) "OPTION: what is wrong (found X); what is allowed".
  [[nodiscard]] bool parse(const std::vector<std::string>& arguments);

  /// What was declared, in its order, for the help screen of `command`.
  [[nodiscard]] std::string help(const std::string& command) const;

 private:
  enum class Kind { flag, once, repeated };
  struct Option {
    OptionText text;
    Kind kind = Kind::flag;
    std::function<void(const std::string& value)> take;
    bool is_given = false;

    [[nodiscard]] bool is_named(std::string_view name) const;
  };

  void add(const OptionText& text, Kind kind, std::function<void(const std::string& value)> take);
  using Argument = std::vector<std::string>::const_iterator;
  /// Takes the option at `argument`; returns the last argument that it used.
  [[nodiscard]] Argument take_option(Argument argument, Argument last);
  /// The long names of all options.
  [[nodiscard]] std::vector<std::string_view> names() const;
  [[nodiscard]] Option& find(const std::string& name);
  void take_files(std::vector<std::string> files) const;

  std::vector<Option> options_;
  std::vector<std::string>* files_ = nullptr;
  OptionText files_text_;
  int least_ = 0;
  int most_ = 0;
};

/// One command: its words on the help screens, and how it is declared. `declare` binds options and
/// returns what is done with them.
struct Command {
  std::string name;
  std::string summary;
  std::string example;
  bool is_common = false;         ///< Is on the first help screen; else under "more".
  bool needs_strict_ieee = true;  ///< Runs only on a machine that passes the self-test.
  std::function<std::function<ExitCode()>(Options&)> declare;
};

/// Parses the command line and does what it says. Help and version go to stdout.
/// ERRORS: Failure(bad_input) for what cannot be understood.
[[nodiscard]] ExitCode run_command_line(const std::vector<std::string>& arguments,
                                        const std::vector<Command>& commands);

}  // namespace hyrax

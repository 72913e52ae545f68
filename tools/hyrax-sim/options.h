// How a command declares what may be given to it; a thin face of CLI11, whose heavy header only
// command_line.cpp sees.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

/// An option's names, as "-o,--output", what its value is called, and what it does.
struct OptionText {
  std::string names;
  std::string value;
  std::string help;
};

class Options {
 public:
  Options() = default;
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;
  virtual ~Options() = default;

  /// Files or folders that stand without a name: at least `least` and at most `most`.
  virtual void files(std::vector<std::string>& into, const OptionText& text, int least, int most) = 0;
  virtual void flag(bool& into, const OptionText& text) = 0;
  virtual void text(std::string& into, const OptionText& text) = 0;
  /// May be given several times, a value each.
  virtual void texts(std::vector<std::string>& into, const OptionText& text) = 0;
  /// A finite number, at least `low`.
  virtual void number(std::optional<double>& into, const OptionText& text, double low) = 0;
  /// A whole number, at least `low`.
  virtual void whole(std::optional<std::int64_t>& into, const OptionText& text, std::int64_t low) = 0;
  /// One of `words`.
  virtual void choice(std::string& into, const OptionText& text, const std::vector<std::string>& words) = 0;
};

/// One command: its words on the help screens, and how it is declared. `declare` binds options and
/// returns what is done with them.
struct Command {
  std::string name;
  std::string summary;
  std::string example;
  bool is_common = false;         ///< Stands on the first help screen; else under "more".
  bool needs_strict_ieee = true;  ///< Runs only on a machine that passes the self-test.
  std::function<std::function<ExitCode()>(Options&)> declare;
};

/// Parses the command line and does what it says. Help and version go to stdout.
/// ERRORS: Failure(bad_input) for what cannot be understood.
[[nodiscard]] ExitCode run_command_line(const std::vector<std::string>& arguments,
                                        const std::vector<Command>& commands);

}  // namespace hyrax

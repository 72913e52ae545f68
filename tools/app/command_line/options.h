// Commands, how they declare their arguments, and how arguments are read from the command line.
//
// Why no library: CLI11 splits a file named `[a,b]` into two and lets an option with several values
// take the files after it; getopt_long accepts abbreviations, which a later option makes ambiguous.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tools/app/command_line/print.h"
#include "tools/files/failure.h"

namespace hyrax {

struct Core;

/// Throws Failure(bad_input) "COMMAND: WHAT; see `COMMAND --help`".
[[noreturn]] void refuse_usage(const std::string& command, const std::string& what);

struct OptionText {
  std::string names;  ///< As "-o,--output".
  std::string value;  ///< The name of its value; empty for a flag.
  std::string help;   ///< What it does; empty: not in the help, as what the program passes to itself.
};

/// Every argument is taken literally: nothing is split, unquoted or expanded. An option takes its value from
/// `--name=VALUE`, `-nVALUE` or the next argument, whatever that looks like; after `--` all arguments are
/// files.
class Options {
 public:
  /// Arguments without an option name: at least `least` and at most `most`; most = -1: any number.
  /// @param when_missing what the message about too few says, as "NAME is missing".
  void files(std::vector<std::string>& into, const OptionText& text, int least, int most,
             const std::string& when_missing = "");
  void flag(bool& into, const OptionText& text);
  void text(std::string& into, const OptionText& text);
  /// May be given several times, a value each.
  void texts(std::vector<std::string>& into, const OptionText& text);
  /// A finite number, at least `low`.
  void number(std::optional<double>& into, const OptionText& text, double low);
  /// A whole number, `low` .. `high`.
  void integer(std::optional<std::int64_t>& into, const OptionText& text, std::int64_t low,
               std::int64_t high = std::numeric_limits<std::int64_t>::max());
  /// A whole number, 0 .. 2^64 - 1.
  void seed(std::optional<std::uint64_t>& into, const OptionText& text);
  /// A time above 0 in s: "90", "90s", "5m", "2h".
  void time(std::optional<double>& into_s, const OptionText& text);
  /// May be given several times, each a value of `allowed`, which are called by `kind`, as "rule".
  void choices(std::vector<std::string>& into, const OptionText& text,
               const std::vector<std::string>& allowed, const std::string& kind);
  /// One of `allowed`.
  void choice(std::string& into, const OptionText& text, const std::vector<std::string>& allowed);
  /// An option that earlier versions had: refused, whatever its value, with `instead`, what to use now, as
  /// "use
  /// --part and --merge". Not in the help.
  void removed(const std::string& names, const std::string& instead);
  /// What every command has: --json, --quiet and --verbose, the last with its own help.
  void printing(Printing& into, const std::string& verbose_help = "no effect");

  /// Sets what was declared, from the arguments of `command`, as "hyrax-sim run". Returns false if help is
  /// requested; not everything is set then.
  /// ERRORS: Failure(bad_input) "COMMAND: OPTION: what is wrong (found X); see `COMMAND --help`".
  [[nodiscard]] bool parse(const std::string& command, const std::vector<std::string>& arguments);

  /// The usage of `command`, its arguments and options in the order of their declaration.
  [[nodiscard]] std::string help(const std::string& command) const;

 private:
  enum class Kind { flag, once, repeated, removed };
  struct Option {
    OptionText text;
    Kind kind = Kind::flag;
    std::function<void(const std::string& value)> set;
    bool is_given = false;

    [[nodiscard]] bool is_named(std::string_view name) const;
    [[nodiscard]] bool is_listed() const { return kind != Kind::removed && !text.help.empty(); }
  };

  [[nodiscard]] bool read(const std::vector<std::string>& arguments);
  void add(const OptionText& text, Kind kind, std::function<void(const std::string& value)> set);
  void add_choice(OptionText text, Kind option_kind, const std::vector<std::string>& allowed,
                  const std::string& kind, std::function<void(const std::string& value)> set);
  using Argument = std::vector<std::string>::const_iterator;
  /// Reads the option at `argument`; returns the last argument that it used.
  [[nodiscard]] Argument read_option(Argument argument, Argument last);
  /// The long names of all options.
  [[nodiscard]] std::vector<std::string_view> names() const;
  [[nodiscard]] Option& find(const std::string& name);
  void set_files(std::vector<std::string> files) const;

  std::vector<Option> options_;
  std::vector<std::string>* files_ = nullptr;
  OptionText files_text_;
  std::string when_missing_;
  int least_ = 0;
  int most_ = 0;
};

/// One command: its help, and its options. `declare` binds the options and returns the function that runs the
/// command with them.
struct Command {
  std::string name;
  std::string summary;
  std::string example;
  bool is_common = false;         ///< Is on the first help screen; else under "more".
  bool needs_strict_ieee = true;  ///< Runs only on a machine that passes the self-test.
  bool needs_paper_step = false;  ///< Does not apply to a core with another step.
  std::function<std::function<ExitCode(const Core& core)>(Options&)> declare;
};

/// A command's member `declare`: binds the options to a request, which `act` gets, after the core if it takes
/// one.
template <class Request, class Declare, class Act>
requires std::is_class_v<Declare>
[[nodiscard]] auto with_request(Declare declare, Act act) {
  return [=](Options& options) {
    const auto request = std::make_shared<Request>();
    declare(options, *request);
    return [=]([[maybe_unused]] const Core& core) {
      if constexpr (std::is_invocable_v<Act, const Core&, Request&>)
        return act(core, *request);
      else
        return act(*request);
    };
  };
}

template <class Request, class Act>
[[nodiscard]] auto with_request(void (*declare)(Options&, Request&), Act act) {
  return with_request<Request>([declare](Options& options, Request& request) { declare(options, request); },
                               std::move(act));
}

}  // namespace hyrax

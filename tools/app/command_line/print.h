// How commands print on standard output, and show progress on a terminal.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "sim/result/result.h"
#include "tools/files/json.h"
#include "tools/files/printable.h"

namespace hyrax {

/// How much a command prints, and in which form.
struct Printing {
  enum class Detail { verdict, normal, all };
  Detail detail = Detail::normal;
  bool is_json = false;  ///< One JSON document; of `detail` only `all` adds to it, in `run`.

  [[nodiscard]] bool is_quiet() const { return detail == Detail::verdict; }
  [[nodiscard]] bool is_verbose() const { return detail == Detail::all; }
};

/// A word of a verdict: green or red where standard output is a terminal, unless NO_COLOR is set or TERM is
/// "dumb".
struct VerdictWord {
  std::string_view word;
  bool is_good;
};

/// The text of an argument of print_text: of a text, its control characters escaped.
[[nodiscard]] std::string printed(const VerdictWord& verdict);
[[nodiscard]] inline std::string printed(std::string_view text) { return printable_lines(text); }
template <class Value>
requires(!std::is_convertible_v<Value, std::string_view>) [[nodiscard]] auto printed(const Value& value) {
  if constexpr (std::is_arithmetic_v<Value>)
    return value;
  else
    return printable_lines(fmt::format("{}", Value(value)));
}

/// As fmt::print; but paths and messages among the values do nothing to a terminal, and a failure to write
/// throws nothing (see is_all_printed).
template <class... Values>
void print_text(fmt::format_string<decltype(printed(std::declval<const Values&>()))...> format,
                const Values&... values) {
  std::fputs(fmt::format(format, printed(values)...).c_str(), stdout);
}

/// Prints the text of a verdict and what does not hold; of `verdict` detail that alone, or NAME: BRIEF.
void print_verdict(const std::string& name, const Verdict& verdict, const Printing& printing);

/// Prints a document and a line end. @param depth_indented as to_text's.
void print_json(const Json& document, int depth_indented = 2);

/// "3 of 12 steps, 1.5 per second, 6 s left"; rate and time left only once something is done.
[[nodiscard]] std::string progress_text(std::int64_t done, std::int64_t total, const std::string& unit,
                                        double elapsed_s);

/// A line on stderr if that is a terminal, after half a second, with rate and time left; erased at the end.
/// The time left is right if all units take about the same time.
class Progress {
 public:
  Progress(std::string unit, std::int64_t total);
  /// For show_text.
  Progress() : Progress("", 0) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  [[nodiscard]] bool is_shown() const { return is_terminal_; }
  void show(std::int64_t done);
  /// Any other text, for work without a known total.
  void show_text(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due();
  void print(const std::string& text);

  std::string unit_;
  std::int64_t total_;
  bool is_terminal_;
  bool has_line_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = start_;
};

}  // namespace hyrax

#include "tools/app/command_line/print.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "tools/files/table_text.h"
#include "tools/platform/standard_streams.h"

namespace hyrax {
namespace {

bool has_colour() {
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return is_terminal(stdout) && (no_color == nullptr || *no_color == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

// The width of standard output, where that is a terminal that knows it.
std::size_t columns_shown(const Printing& printing) {
  const auto columns = printing.is_verbose() ? std::nullopt : terminal_columns();
  return columns.value_or(std::numeric_limits<std::size_t>::max());
}

}  // namespace

std::string printed(const VerdictWord& verdict) {
  static const bool is_coloured = has_colour();
  if (!is_coloured) return std::string(verdict.word);
  return fmt::format("\x1b[{}m{}\x1b[0m", verdict.is_good ? 32 : 31, verdict.word);
}

void print_verdict(const std::string& name, const Verdict& verdict, const Printing& printing) {
  if (!printing.is_quiet() && !verdict.answer.empty()) print_text("{}\n", verdict.answer);
  if (!printing.is_quiet())
    for (const auto& part : verdict.text) {
      if (const auto* const table = std::get_if<Table>(&part))
        print_text("{}", aligned_text(*table, columns_shown(printing)));
      else
        print_text("{}\n", std::get<std::string>(part));
    }
  for (const std::string& sentence : verdict.broken)
    print_text("{}: {}\n", VerdictWord{"does not hold", false}, sentence);
  if (printing.is_quiet() && verdict.broken.empty())
    print_text("{}: {}\n", name, VerdictWord{verdict.brief, true});
}

void print_json(const Json& document, int depth_indented) {
  print_text("{}\n", to_text(document, depth_indented));
}

std::string progress_text(std::int64_t done, std::int64_t total, const std::string& unit, double elapsed_s) {
  const std::string text = fmt::format("{} of {} {}", done, total, unit);
  if (done <= 0 || elapsed_s <= 0.0) return text;
  const double rate = static_cast<double>(done) / elapsed_s;
  return text + fmt::format(", {:.3g} per second, {:.0f} s left", rate,
                            static_cast<double>(std::max<std::int64_t>(total - done, 0)) / rate);
}

Progress::Progress(std::string unit, std::int64_t total)
    : unit_(std::move(unit)), total_(total), is_terminal_(hyrax::is_terminal(stderr)) {}

Progress::~Progress() {
  if (has_line_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::int64_t done) {
  if (is_due())
    print(progress_text(done, total_, unit_, std::chrono::duration<double>(last_shown_ - start_).count()));
}

void Progress::show_text(const std::string& text) {
  if (is_due()) print(text);
}

bool Progress::is_due() {
  using std::chrono::duration;
  const Clock::time_point now = Clock::now();
  if (!is_terminal_ || duration<double>(now - start_).count() < 0.5 ||
      duration<double>(now - last_shown_).count() < 0.1)
    return false;
  last_shown_ = now;
  return true;
}

void Progress::print(const std::string& text) {
  has_line_ = true;
  // Unlike fmt::print, this throws nothing if the terminal was closed.
  std::fputs(("\r\x1b[K" + text).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace hyrax

// hyrax-compare: what a candidate core would change.
#include <charconv>
#include <chrono>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "sim/physics/strict_arithmetic.h"
#include "tools/files/failure.h"
#include "tools/files/main_program.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/unknown_word.h"
#include "tools/hyrax-compare/card_output.h"
#include "tools/hyrax-compare/core_file.h"
#include "tools/report/page_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr char kHelp[] =
    "hyrax-compare prints what a candidate core would change, each line with its interval.\n\n"
    "  hyrax-compare my_physics.h\n\n"
    "Usage: hyrax-compare CANDIDATE.h [BASE.h] [OPTION]...\n\n"
    "CANDIDATE.h and BASE.h each define `class physics` as sim/physics/physics.h does, which is the base if "
    "none\n"
    "is given. They are compiled with the compiler and the flags of this build.\n\n"
    "  --json            print JSON\n"
    "  --report FILE.html\n"
    "                    also write the card as a page, with its figures and what differs one by one\n"
    "  --scenarios DIR   the scenario library (default: scenarios of the project); recordings and hard cases "
    "are\n"
    "                    made from its folders `recorded` and `hard`\n"
    "  --seed N          of the random flings and runs (default 1)\n"
    "  --flings N        random flings (default 1000; 1 .. 100000)\n"
    "  --limit S         refuse a candidate that takes longer to measure (default 300 s; 1 .. 86400)\n"
    "  --help            print this\n\n"
    "Exit codes: 0 printed, whatever differs; 2 bad usage, or a core that does not compile or is refused; 3 "
    "cannot\n"
    "read; 5 arithmetic is not strict IEEE-754; 70 internal error.\n";

struct Arguments {
  std::vector<std::string> headers;
  std::string scenarios = HYRAX_SOURCE_DIR "/scenarios";
  std::uint64_t seed = 1;
  std::int64_t flings = 1000;
  unsigned limit_s = 300;
  std::string report;   ///< The page to write; empty: none.
  std::string command;  ///< As it was called.
  bool is_json = false;
  bool is_help = false;
  std::string probed_library;
};

Failure bad_usage(const std::string& sentence) {
  return {ExitCode::bad_input, "hyrax-compare: " + sentence + "; see `hyrax-compare --help`"};
}

template <class Number>
Number number_in(const std::string& option, const std::string& text, Number low, Number high) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
    throw bad_usage(option + ": must be an integer " + std::to_string(low) + " .. " + std::to_string(high) +
                    " (found " + text + ")");
  return value;
}

Arguments parsed(const std::vector<std::string>& words) {
  constexpr std::int64_t kFlingsMax = 100'000;
  Arguments arguments;
  arguments.command = fmt::format("hyrax-compare {}", fmt::join(words, " "));
  for (std::size_t index = 0; index < words.size(); ++index) {
    const std::string& word = words[index];
    const auto value = [&]() -> const std::string& {
      if (index + 1 == words.size()) throw bad_usage(word + ": its value is missing");
      return words[++index];
    };
    if (word == "--help")
      arguments.is_help = true;
    else if (word == "--json")
      arguments.is_json = true;
    else if (word == "--report")
      arguments.report = value();
    else if (word == "--scenarios")
      arguments.scenarios = value();
    else if (word == "--seed")
      arguments.seed = number_in<std::uint64_t>(word, value(), 0, UINT64_MAX);
    else if (word == "--flings")
      arguments.flings = number_in<std::int64_t>(word, value(), 1, kFlingsMax);
    else if (word == "--limit")
      arguments.limit_s = number_in<unsigned>(word, value(), 1, 86'400);
    else if (word == kProbeOption)
      arguments.probed_library = value();
    else if (word.starts_with('-'))
      throw bad_usage(unknown_word(
          "option", word, {"--json", "--report", "--scenarios", "--seed", "--flings", "--limit", "--help"}));
    else
      arguments.headers.push_back(word);
  }
  return arguments;
}

// Paths relative to the library's folder.
std::vector<NamedScenario> read_scenarios(const std::string& folder) {
  std::vector<NamedScenario> scenarios;
  for (const std::string& path : list_scenarios({folder}))
    scenarios.push_back(
        {std::filesystem::path(path).lexically_relative(folder).string(), load_scenario(path)});
  return scenarios;
}

std::vector<NamedScenario> in_folder(const std::vector<NamedScenario>& scenarios, const std::string& folder) {
  std::vector<NamedScenario> found;
  for (const NamedScenario& named : scenarios)
    if (named.path.starts_with(folder + "/")) found.push_back(named);
  return found;
}

std::int64_t steady_now_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ExitCode print_card(const Arguments& arguments) {
  const std::string& candidate_header = arguments.headers.front();
  const bool has_base = arguments.headers.size() > 1;
  const std::string base_header = has_base ? arguments.headers.back() : "sim/physics/physics.h";
  if (!arguments.report.empty()) {
    require_page();
    OutputGuard(arguments.headers).admit("hyrax-compare: --report", arguments.report, {".html"});
  }
  const CardRequest request = [&arguments] {
    CardRequest read{.library = read_scenarios(arguments.scenarios),
                     .seed = arguments.seed,
                     .flings = arguments.flings,
                     .now_ns = steady_now_ns};
    read.recordings = in_folder(read.library, "recorded");
    read.hard = in_folder(read.library, "hard");
    return read;
  }();
  const TemporaryFolder folder;
  auto base_library = std::async(std::launch::async, [&] {
    return has_base ? compile_core(base_header, folder, "base") : shipped_core_library();
  });
  const std::string candidate_library = compile_core(candidate_header, folder, "candidate");
  const CoreFunctions& base = checked_core(base_library.get(), base_header);
  const CoreFunctions& candidate = checked_core(candidate_library, candidate_header);
  const CardTitle title{candidate_header, base_header};
  try {
    refuse_on_crash(candidate_header, arguments.limit_s);
    const Card card = measure_card(base, candidate, request);
    print_text(arguments.is_json ? to_text(card_json(card, title), {.depth_indented = 2}) + "\n"
                                 : card_text(card, title));
    if (!arguments.report.empty()) write_card_page(arguments.report, arguments.command, card, title);
  } catch (const CoreRefused& reason) {
    throw Failure(ExitCode::bad_input, candidate_header + ": refused: " + reason.what());
  }
  return ExitCode::agreed;
}

ExitCode run(const std::vector<std::string>& words) {
  const Arguments arguments = parsed(words);
  if (arguments.is_help) {
    print_text(kHelp);
    return ExitCode::agreed;
  }
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax-compare: " + std::string(*fault));
  if (!arguments.probed_library.empty()) {
    print_text(probe_text(load_core(arguments.probed_library)));
    return ExitCode::agreed;
  }
  if (arguments.headers.empty() || arguments.headers.size() > 2)
    throw bad_usage(fmt::format("CANDIDATE.h and at most one BASE.h are allowed (found {} files)",
                                arguments.headers.size()));
  return print_card(arguments);
}

}  // namespace
}  // namespace hyrax

int main(int argument_count, char** arguments) {
  return hyrax::run_program("hyrax-compare", argument_count, arguments, hyrax::run);
}

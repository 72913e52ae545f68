// hyrax-compare: what a candidate core would change.
#include <chrono>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "sim/card/card.h"
#include "sim/physics/strict_arithmetic.h"
#include "tools/app/command_line/options.h"
#include "tools/files/failure.h"
#include "tools/files/main_program.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-compare/card_report.h"
#include "tools/hyrax-compare/core_file.h"
#include "tools/report/page_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

constexpr std::string_view kName = "hyrax-compare";
constexpr std::string_view kSummary =
    "Prints what a candidate core would change, each line with its interval.\n\n"
    "CANDIDATE.h and BASE.h each define `class physics` as sim/physics/physics.h does, which is the\n"
    "candidate if none is given. The base is the accepted core, golden/core, if none is given. They are\n"
    "compiled with the compiler and the flags of this build.\n";
constexpr std::string_view kExitCodes = R"(
Exit codes: 0 printed, whatever differs; 1 golden/core is damaged; 2 bad usage, or a core that does not
compile or is refused; 3 cannot read; 4 no golden/core; 5 arithmetic is not strict IEEE-754; 70 internal
error.
)";

struct Arguments {
  std::vector<std::string> headers;
  std::string scenarios = HYRAX_SOURCE_DIR "/scenarios";
  std::string golden;  ///< Empty: the project's.
  std::optional<std::int64_t> seed;
  std::optional<std::int64_t> flings;
  std::optional<std::int64_t> limit_s;
  std::string report;  ///< The page to write; empty: none.
  bool is_json = false;
};

void declare(Options& options, Arguments& into) {
  options.files(into.headers, {"CANDIDATE.h [BASE.h]", "", "the cores to compare"}, 0, 2);
  options.flag(into.is_json, {"--json", "", "print JSON"});
  options.text(into.report, {"--report", "FILE.html",
                             "also write the card as a page, with its figures\nand what differs one by one"});
  options.text(
      into.scenarios,
      {"--scenarios", "DIR",
       "the scenario library (default: scenarios of the\nproject); recordings and hard cases are made "
       "from\nits folders `recorded` and `hard`"});
  options.text(into.golden, {"--golden", "DIR",
                             "golden files, whose accepted core is the base if none\nis given (default: "
                             "golden of the project)"});
  options.integer(into.seed, {"--seed", "N", "of the random flings and runs (default 1)"}, 0);
  options.integer(into.flings, {"--flings", "N", "random flings (default 1000)"}, 1, 100'000);
  options.integer(into.limit_s,
                  {"--limit", "S", "refuse a candidate that takes longer to measure\n(default 300 s)"}, 1,
                  86'400);
}

// Paths relative to the library's folder.
std::vector<NamedScenario> read_scenarios(const std::string& folder) {
  std::vector<NamedScenario> scenarios;
  for (const std::string& path : list_scenarios({folder}))
    scenarios.push_back(
        {std::filesystem::path(path).lexically_relative(folder).string(), load_scenario(path)});
  return scenarios;
}

std::int64_t steady_now_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The hash of the library's rows by a core without a defect. ERRORS: CoreRefused.
std::string probed(const CoreFile& file, int number, const CardRequest& request, PlayWatch& watch) {
  const LibraryCore& library = load_library(file.library, number, watch);
  std::string rows = rows_hash(compared_core(number, library, file.core.record(), watch), request);
  watch.set_place("the search for hidden state");
  if (const std::string defect = library.defect(); !defect.empty()) throw CoreRefused(number, defect);
  return rows;
}

ExitCode print_card(const Arguments& arguments, const std::string& command) {
  const bool has_candidate = !arguments.headers.empty();
  const bool has_base = arguments.headers.size() > 1;
  const BeforeAfter<std::string> headers = {
      .before = has_base ? arguments.headers.back()
                         : accepted_core_folder(arguments.golden.empty() ? "golden" : arguments.golden) +
                               "/physics.h",
      .after = has_candidate ? arguments.headers.front() : "sim/physics/physics.h"};
  if (!arguments.report.empty()) {
    OutputGuard(arguments.headers, arguments.golden)
        .admit_file("hyrax-compare: --report", arguments.report, {".html"});
    require_page();
  }
  CardRequest request{.library = read_scenarios(arguments.scenarios),
                      .seed = static_cast<std::uint64_t>(arguments.seed.value_or(1)),
                      .flings = arguments.flings.value_or(1000),
                      .now_ns = steady_now_ns};
  const TemporaryFolder folder;
  auto base_made = std::async(std::launch::async, [&] {
    return has_base ? make_core(headers.before, folder, "base")
                    : core_of_golden(built_core_record(),
                                     arguments.golden.empty() ? HYRAX_SOURCE_DIR "/golden" : arguments.golden,
                                     folder, "base");
  });
  const CoreFile candidate = has_candidate ? make_core(headers.after, folder, "candidate")
                                           : core_of_project(built_core_record(), folder, "candidate");
  const CoreFile base = base_made.get();
  request.proof = prove_equal(headers.before, base.core.record(), candidate.core.record());
  request.changes = header_changes(base.core.header, candidate.core.header);
  const bool is_same = request.proof.is_equal && base.core.header == candidate.core.header;
  if (!has_candidate && is_same && !arguments.is_json && arguments.report.empty()) {
    print_text(headers.after + " is the accepted core, " + headers.before + ": nothing to compare\n");
    return ExitCode::agreed;
  }
  const auto in_process = [&](const std::function<std::string(PlayWatch&)>& work) {
    return in_core_process(headers, static_cast<unsigned>(arguments.limit_s.value_or(300)), folder, work);
  };
  request.rows_hash.before = in_process([&](PlayWatch& watch) { return probed(base, 0, request, watch); });
  request.rows_hash.after =
      in_process([&](PlayWatch& watch) { return probed(candidate, 1, request, watch); });
  print_text(in_process([&](PlayWatch& watch) {
    const ComparedCores cores{load_core(base, 0, watch), load_core(candidate, 1, watch)};
    const Result card = card_result(measure_card(cores, request));
    if (!arguments.report.empty()) write_result_page(arguments.report, command, {shown_card(card, headers)});
    return (arguments.is_json ? card_json : card_text)(card, headers);
  }));
  return ExitCode::agreed;
}

ExitCode run(const std::vector<std::string>& words) {
  Arguments arguments;
  Options options;
  declare(options, arguments);
  if (!options.parse(std::string(kName), words)) {
    print_text(std::string(kSummary) + "\n" + options.help(std::string(kName)) + std::string(kExitCodes));
    return ExitCode::agreed;
  }
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, std::string(kName) + ": " + std::string(*fault));
  return print_card(arguments, fmt::format("{} {}", kName, fmt::join(words, " ")));
}

}  // namespace
}  // namespace hyrax

int main(int argument_count, char** arguments) {
  return hyrax::run_program("hyrax-compare", argument_count, arguments, hyrax::run);
}

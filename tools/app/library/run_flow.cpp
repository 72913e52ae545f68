#include "tools/app/library/run_flow.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "tools/app/command_line/shell_command.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/csv_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

// Values that --set replaces in a scenario.
std::vector<Override> overrides_of(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || !text.starts_with('/'))
      refuse_input("hyrax-sim run: --set: not POINTER=VALUE (found " + text + "); as in /clock/rate_hz=144");
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

// A scenario that was read, or why it was not.
struct Candidate {
  std::string path;
  std::optional<LoadedScenario> scenario = {};
  std::string output = {};
  std::optional<Failure> failure = {};
};

bool writes_into_folder(const RunRequest& request, std::size_t scenarios) {
  return scenarios > 1 || request.output.ends_with('/') || is_folder(request.output);
}

void place_outputs(const RunRequest& request, OutputGuard& guard, std::vector<Candidate>& candidates) {
  const bool is_to_stdout = request.output == kStandardOutput || request.output == "/dev/stdout";
  // CSV; nothing else is printed there.
  if (is_to_stdout &&
      (candidates.size() > 1 || request.printing.is_json || request.measures_drift || !request.page.empty()))
    refuse_input("hyrax-sim run: -o " + request.output +
                 ": allowed for one scenario, without --json, --drift and --report");
  for (Candidate& candidate : candidates) {
    if (is_to_stdout) candidate.output = kStandardOutput;
    if (is_to_stdout || !candidate.scenario) continue;
    const bool is_in_folder = request.output.empty() || writes_into_folder(request, candidates.size());
    candidate.output =
        is_in_folder
            ? (std::filesystem::path(request.output) / (candidate.scenario->name + ".h5")).generic_string()
            : request.output;
    guard.admit("hyrax-sim run: -o of " + candidate.path, candidate.output, {".h5", ".csv"});
  }
}

}  // namespace

ExitCode run_scenarios(
    RunRequest& request,
    const std::function<LoadedScenario(const std::string& path, const std::vector<Override>&)>& load,
    const RunSteps& steps) {
  const std::vector<Override> overrides = overrides_of(request.overrides);
  const std::vector<std::string> paths = list_scenarios(request.files);
  constexpr std::size_t kPrintedInFullMax = 3;
  if (paths.size() > kPrintedInFullMax && !request.printing.is_verbose())
    request.printing.detail = Printing::Detail::verdict;
  request.shows_sheet = paths.size() > 1 && !(request.figure + request.page).empty();
  std::vector<Candidate> candidates;
  for (const std::string& path : paths) {
    Candidate& candidate = candidates.emplace_back(Candidate{.path = path});
    candidate.failure = failure_of(path, [&] { candidate.scenario = load(path, overrides); });
  }
  OutputGuard guard(paths, request.golden_folder);
  place_outputs(request, guard, candidates);
  if (!request.figure.empty()) guard.admit_file("hyrax-sim run: --figure", request.figure, {".svg"});
  if (!request.page.empty()) guard.admit_file("hyrax-sim run: --report", request.page, {".html"});
  std::vector<std::string> outputs;
  for (const Candidate& candidate : candidates)
    if (candidate.scenario) outputs.push_back(candidate.output);
  if (steps.require) steps.require(outputs);
  if (!outputs.empty() && !request.output.empty() && writes_into_folder(request, candidates.size()))
    make_folder(request.output, "cannot be created");
  CommandResults results;
  std::vector<RunPanel> panels;
  for (const Candidate& candidate : candidates) {
    panels.push_back({.name = std::string(file_name(candidate.path).stem), .status = "failed"});
    results.attempt(candidate.path, [&] {
      if (candidate.failure) throw *candidate.failure;
      panels.back() = candidate.scenario->run(candidate.output, results);
    });
  }
  CommandResults of_sheet;  // No scenario fails with it.
  if (request.shows_sheet && !request.figure.empty())
    of_sheet.attempt_after([&] {
      write_text_file(request.figure, contact_sheet_svg(panels));
      print_written(request, request.figure);
    });
  if (request.shows_sheet && !request.page.empty())
    of_sheet.attempt_after([&] {
      if (std::ranges::all_of(panels, [](const RunPanel& panel) { return panel.status == "failed"; }))
        refuse_input("hyrax-sim run: --report: no scenario was run; " + request.page + " is not written");
      steps.write_page(panels);
      print_written(request, request.page);
    });
  results.add(of_sheet.exit_code());
  if (request.printing.is_json) print_json(results.take_json("runs"), 3);
  return results.exit_code();
}

void print_written(const RunRequest& request, const std::string& path) {
  if (!request.printing.is_json)
    print_text("{}{}\n", request.printing.is_quiet() ? "written: " : "  written        ", path);
}

std::string page_command(const RunRequest& request, const std::vector<std::string>& scenarios) {
  std::vector<std::string> command = {"run"};
  for (const std::string& path : scenarios) command.push_back(as_argument(path));
  for (const std::string& text : request.overrides) command.insert(command.end(), {"--set", text});
  if (!request.golden_folder.empty()) command.insert(command.end(), {"--golden", request.golden_folder});
  command.insert(command.end(), {"--report", request.page});
  return program_command(command);
}

std::string joined_names(const std::vector<std::string>& names) {
  return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

void print_expectations(const std::vector<Expectation>& expectations, bool all) {
  if (expectations.empty()) return;
  const auto holding = std::ranges::count_if(expectations, &Expectation::holds);
  print_text("  expect         {} of {} hold\n", holding, expectations.size());
  for (const Expectation& expectation : expectations)
    if (all || !expectation.holds)
      print_text("    {}: {}\n",
                 expectation.holds ? VerdictWord{"holds", true} : VerdictWord{"does not hold", false},
                 expectation_text(expectation));
}

void declare_run(Options& options, RunRequest& request, const std::string& figure_help,
                 const std::string& page_help) {
  options.files(
      request.files,
      {"SCENARIO", "",
       "scenario files, or folders of them; - for standard input; of more than three, a line each (all: -v)"},
      1, -1);
  options.text(request.output, {"-o,--output", "FILE or DIR",
                                "FILE.h5, FILE.csv, - for CSV on standard output, or a folder (default: "
                                "NAME.h5 in the current folder)"});
  options.texts(request.overrides,
                {"--set", "POINTER=VALUE", "replace a value of the file, by JSON Pointer"});
  options.text(request.figure, {"--figure", "FILE.svg", figure_help});
  options.text(request.page, {"--report", "FILE.html", page_help});
  options.text(request.golden_folder,
               {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
}

}  // namespace hyrax

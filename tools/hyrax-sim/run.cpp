#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/core/core.h"
#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/overrides.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/drift/drift.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/table_text.h"
#include "tools/report/page_file.h"
#include "tools/store/output_guard.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct RunRequest {
  std::vector<std::string> files;
  std::string output;
  std::vector<std::string> overrides;
  std::string figure;
  std::string page;
  std::string golden_folder;
  ReferenceRequest reference{.name = "closed", .stepper = "", .tolerance = {}};
  bool measures_drift = false;
  bool stores_rows = false;
  bool computes_all = false;
  Printing printing;
};

// A scenario that was read, or why it was not.
struct Candidate {
  std::string path;
  std::optional<Scenario> scenario = {};
  std::string output = {};
  std::optional<Failure> failure = {};
};

Candidate read_candidate(const std::string& path, const std::vector<Override>& overrides) {
  Candidate candidate{.path = path};
  try {
    candidate.scenario = load_scenario(path, overrides);
  } catch (const Failure& failure) {
    candidate.failure = failure;
  }
  return candidate;
}

bool writes_into_folder(const RunRequest& request, std::size_t scenarios) {
  return scenarios > 1 || request.output.ends_with('/') || is_folder(request.output);
}

// CSV on standard output; nothing else is printed there.
void place_on_stdout(const RunRequest& request, std::vector<Candidate>& candidates) {
  if (candidates.size() > 1 || request.printing.is_json || request.measures_drift || !request.page.empty())
    refuse_input("hyrax-sim run: -o " + request.output +
                 ": allowed for one scenario, without --json, --drift and --report");
  candidates.front().output = kStandardOutput;
}

void place_outputs(const RunRequest& request, OutputGuard& guard, std::vector<Candidate>& candidates) {
  if (request.output == "-" || request.output == "/dev/stdout") return place_on_stdout(request, candidates);
  for (Candidate& candidate : candidates) {
    if (!candidate.scenario) continue;
    const bool is_in_folder = request.output.empty() || writes_into_folder(request, candidates.size());
    candidate.output = is_in_folder ? (fs::path(request.output) / (candidate.scenario->name + ".h5")).string()
                                    : request.output;
    guard.admit("hyrax-sim run: -o of " + candidate.path, candidate.output, {".h5", ".csv"});
    if (request.stores_rows && file_name(candidate.output).extension == ".csv")
      refuse_input("hyrax-sim run: --rows: not possible in a CSV file (found " + candidate.output +
                   "); allowed: .h5");
  }
}

std::optional<DriftOptions> stored_drift(const Core& core, const RunRequest& request) {
  if (request.measures_drift) require_paper_core(core, "hyrax-sim run: --drift");
  if (request.measures_drift)
    return DriftOptions{.gsl = gsl_options(request.reference, "hyrax-sim run"),
                        .encloses = request.printing.is_json,
                        .stores_rows = request.stores_rows};
  if (request.stores_rows || request.reference.is_given())
    refuse_input("hyrax-sim run: --rows, --reference, --stepper and --tolerance need --drift");
  return std::nullopt;
}

void report(const Core& core, const RunRequest& request, const ScenarioRun& run, CommandResults& results) {
  DriftReport drift;
  if (run.drift) drift = {.run = *run.drift, .has_rows_stored = request.stores_rows};
  if (!request.printing.is_json) {
    if (run.output == kStandardOutput)
      print_error(run.scenario.name + ": " + run.status());
    else
      print_run(core, run, request.printing);
    if (run.drift)
      print_verdict(run.scenario.name, drift_result(drift, request.printing.is_verbose()).verdict,
                    request.printing);
    return;
  }
  Json entry = run_json(core, run);
  if (run.drift) {
    Json::Object measured;
    add_members(measured, drift_result(drift, false).summary);
    entry.get<Json::Object>()->emplace_back("drift", std::move(measured));
  }
  results.add(std::move(entry));
}

void print_written(const RunRequest& request, const std::string& path) {
  if (!request.printing.is_json)
    print_text("{}{}\n", request.printing.is_quiet() ? "written: " : "  written        ", path);
}

void write_page(const Core& core, const RunRequest& request, const ScenarioRun& run) {
  std::vector<std::string> command = {"run", as_argument(run.path)};
  for (const std::string& text : request.overrides) command.insert(command.end(), {"--set", text});
  if (!request.golden_folder.empty()) command.insert(command.end(), {"--golden", request.golden_folder});
  command.insert(command.end(), {"--report", request.page});
  write_report(core, {.files = {run.output},
                      .against = run.comparison ? run.golden_path : "",
                      .output = request.page,
                      .command = program_command(command)});
  print_written(request, request.page);
}

void run_one(const Core& core, const RunRequest& request, const std::optional<DriftOptions>& drift,
             const Candidate& candidate, CommandResults& results) {
  if (candidate.failure) throw *candidate.failure;
  require_measurable(core, candidate.path, *candidate.scenario);
  std::optional<RunPicture> picture;
  if (!request.figure.empty()) picture.emplace(*candidate.scenario);
  const ScenarioRun run =
      run_scenario(core, candidate.path, *candidate.scenario, candidate.output,
                   {.golden_folder = request.golden_folder,
                    .skips_repetition = !request.computes_all,
                    .compares = request.overrides.empty(),
                    .drift = drift,
                    .measures_start = request.printing.is_verbose() && !drift && core.constants,
                    .picture = picture ? &*picture : nullptr});
  if (run.drift) results.add(drift_exit_code(*run.drift));
  if (!run.is_as_expected()) results.add(ExitCode::disagreed);
  report(core, request, run, results);
  if (run.drift) results.attempt_after([&] { require_reached(*run.drift); });
  if (!request.page.empty()) results.attempt_after([&] { write_page(core, request, run); });
  if (!picture) return;
  results.attempt_after([&] {
    picture->draw(request.figure, run);
    if (run.output != kStandardOutput) print_written(request, request.figure);
  });
}

ExitCode run(const Core& core, RunRequest request) {
  const std::vector<Override> overrides = overrides_of("hyrax-sim run", request.overrides);
  const std::vector<std::string> paths = list_scenarios(request.files);
  constexpr std::size_t kPrintedInFullMax = 3;
  if (paths.size() > kPrintedInFullMax && !request.printing.is_verbose())
    request.printing.detail = Printing::Detail::verdict;
  for (const auto& [option, file] : {std::pair("--figure", request.figure), {"--report", request.page}})
    if (!file.empty() && paths.size() > 1)
      refuse_input(
          fmt::format("hyrax-sim run: {}: allowed for one scenario only (found {})", option, paths.size()));
  if (!request.page.empty() && file_name(request.output).extension == ".csv")
    refuse_input("hyrax-sim run: --report: not possible with a CSV file (found " + request.output +
                 "); allowed: .h5");
  std::vector<Candidate> candidates;
  for (const std::string& path : paths) candidates.push_back(read_candidate(path, overrides));
  OutputGuard guard(paths, request.golden_folder);
  place_outputs(request, guard, candidates);
  if (!request.figure.empty()) guard.admit_file("hyrax-sim run: --figure", request.figure, {".svg"});
  if (!request.page.empty()) {
    guard.admit_file("hyrax-sim run: --report", request.page, {".html"});
    require_page();
  }
  const std::optional<DriftOptions> drift = stored_drift(core, request);
  const bool has_scenario =
      std::ranges::any_of(candidates, [](const Candidate& each) { return each.scenario.has_value(); });
  if (has_scenario && !request.output.empty() && writes_into_folder(request, candidates.size()))
    make_folder(request.output, "cannot be created");
  CommandResults results;
  for (const Candidate& candidate : candidates)
    results.attempt(candidate.path, [&] { run_one(core, request, drift, candidate, results); });
  if (request.printing.is_json) print_json(results.take_json("runs"), 3);
  return results.exit_code();
}

void declare(Options& options, RunRequest& request) {
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
  options.text(request.figure, {"--figure", "FILE.svg", "draw window, path and contacts to scale"});
  options.text(request.page, {"--report", "FILE.html", "write a page that replays the run in the browser"});
  options.text(request.golden_folder,
               {"--golden", "DIR", "folder of golden files (default: the `golden` beside `scenarios`)"});
  options.flag(request.measures_drift,
               {"--drift", "", "measure against the reference, as the command `drift` does"});
  options.flag(request.stores_rows, {"--rows", "", "with --drift: store the errors of every row"});
  declare_reference(options, request.reference);
  options.flag(request.computes_all, {"--no-skip", "", "compute also the steps that repeat exactly"});
  options.printing(
      request.printing,
      "print also clamped steps, the period of a repeating state, and how the run depends on its start");
}

}  // namespace

Command run_command() {
  return {.name = "run",
          .summary = "replay scenarios, write their trajectories and compare them with golden files",
          .example =
              "hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
              "  hyrax-sim run scenarios/flings/first-fling.json --set /clock/rate_hz=144 --set /steps=1440 "
              "--set /expect={} -o at-144-hz.h5",
          .is_common = true,
          .declare = with_request<RunRequest>(declare, run)};
}

}  // namespace hyrax

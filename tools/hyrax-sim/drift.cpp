#include <fmt/format.h>

#include <fstream>
#include <string_view>

#include "tools/app/command_line/command_results.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/drift/drift.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/table_text.h"
#include "tools/platform/path.h"
#include "tools/report/drift_figure.h"
#include "tools/report/figure_svg.h"
#include "tools/report/result_page.h"
#include "tools/run_core/run_core.h"
#include "tools/store/output_guard.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

struct DriftRequest {
  std::vector<std::string> files;
  ReferenceRequest reference{.name = "gsl", .stepper = "", .tolerance = {}};
  std::string output;
  std::string figures;
  std::string page;
  bool stores_rows = false;
  Printing printing;
};

// A scenario or trajectory file that was read, or why it was not.
struct DriftInput {
  std::string path;
  bool is_file = false;               // A trajectory file.
  std::optional<FileHead> head = {};  // Of a scenario file, the scenario alone.
  std::optional<Failure> failure = {};
};

// Whether the path is a trajectory file's. By name first: a file with damaged first bytes is reported as a
// bad trajectory. A pipe is not opened: reading its first bytes would consume them, or wait for them.
bool is_trajectory(const std::string& path) {
  if (path.ends_with(".h5")) return true;
  if (!is_regular_file(path)) return false;
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  char begin[kSignature.size()] = {};
  std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
  return std::string_view(begin, sizeof begin) == kSignature;
}

DriftInput read_input(const std::string& path) {
  DriftInput input{path, is_trajectory(path)};
  input.failure = failure_of(path, [&] {
    if (input.is_file)
      input.head = TrajectoryFile::open(path).head();
    else
      input.head.emplace().scenario = load_scenario(path);
  });
  return input;
}

DriftRun measure(const Core& core, const DriftRequest& request, const DriftInput& input,
                 const DriftOptions& options) {
  if (request.output.empty())
    return input.is_file ? load_drift(core, input.path, options)
                         : measure_drift(core, input.head->scenario, options);
  if (input.is_file) refuse_input(input.path + ": is a trajectory; -o needs a scenario");
  return *write_run(core, request.output, input.head->scenario, {.replay = {}, .drift = options}).drift;
}

void report(const DriftRequest& request, const std::string& path, const DriftReport& report,
            CommandResults& results) {
  const Result result = drift_result(report, request.printing.is_verbose());
  if (!request.printing.is_json)
    return print_verdict(report.run.scenario.name, result.verdict, request.printing);
  Json::Object entry{{"scenario", path}};
  add_members(entry, result.summary);
  results.add(Json(std::move(entry)));
}

// The answer, its picture, and what it rests on.
ShownResult shown_drift(const DriftReport& report) {
  Result result = drift_result(report, false);
  Figure figure = drift_figure(report.run);
  std::erase_if(result.summary, [](const Table& table) { return table.long_name.empty(); });
  std::erase_if(result.verdict.text, [](const auto& part) { return std::holds_alternative<Table>(part); });
  for (Table& table : result.summary)
    if (row_count(table) > 0)
      std::erase_if(table.columns, [](const Column& column) { return printed_values(column).empty(); });
  return {.title = figure.title,
          .subtitle = title_of(report.run.scenario, report.run.steps, report.run.simulated_s),
          .verdict = std::move(result.verdict),
          .judgement = "The reference is sound.",
          .tables = std::move(result.summary),
          .figures = {std::move(figure)},
          .origin = {{"reference", "exact fling; closed form"}, {"checked by", report.run.checked_by}}};
}

void measure_one(const Core& own_core, const DriftRequest& request, const std::optional<GslOptions>& gsl,
                 const DriftInput& input, std::vector<ShownResult>& shown, CommandResults& results) {
  if (input.failure) throw *input.failure;
  const Core core = input.is_file ? core_of_file(own_core, input.path, *input.head)
                                  : run_core(own_core, input.path, input.head->scenario);
  require_paper_core(core, input.path);
  DriftReport measured{.run = measure(core, request, input,
                                      {.gsl = gsl,
                                       .keeps_rows = !request.figures.empty() || !request.page.empty(),
                                       .encloses = request.printing.is_json || !request.page.empty(),
                                       .stores_rows = request.stores_rows}),
                       .has_rows_stored = request.stores_rows};
  const DriftRun& run = measured.run;
  measured.half_dt = measure_half_dt(core, run.scenario);
  results.add(drift_exit_code(run));
  report(request, input.path, measured, results);
  results.attempt_after([&] { require_reached(run); });
  if (!request.page.empty()) shown.push_back(shown_drift(measured));
  if (request.figures.empty()) return;
  results.attempt_after([&] {
    make_folder(request.figures, "cannot be created");
    const std::string file = drift_figure_path(request.figures, run.scenario.name);
    draw_figure(file, drift_figure(run));
    if (!request.printing.is_json) print_error("written: " + file);
  });
}

void admit_outputs(const DriftRequest& request, const std::vector<std::string>& paths,
                   const std::vector<DriftInput>& inputs) {
  OutputGuard guard(paths);
  if (!request.output.empty()) guard.admit_file("hyrax-sim drift: -o", request.output, {".h5"});
  if (!request.page.empty()) guard.admit_file("hyrax-sim drift: --report", request.page, {".html"});
  if (request.figures.empty()) return;
  for (const DriftInput& input : inputs)
    if (input.head)
      guard.admit("hyrax-sim drift: --figures of " + input.path,
                  drift_figure_path(request.figures, input.head->scenario.name));
}

ExitCode drift(const Core& core, const DriftRequest& request) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  if (request.stores_rows && request.output.empty())
    refuse_input("hyrax-sim drift: --rows: needs -o FILE.h5");
  if (!request.output.empty() && paths.size() > 1)
    refuse_input(
        fmt::format("hyrax-sim drift: -o: allowed for one scenario only (found {}); for several: "
                    "hyrax-sim run --drift -o DIR",
                    paths.size()));
  const std::optional<GslOptions> gsl = gsl_options(request.reference, "hyrax-sim drift");
  std::vector<DriftInput> inputs;
  for (const std::string& path : paths) inputs.push_back(read_input(path));
  admit_outputs(request, paths, inputs);
  CommandResults results;
  std::vector<ShownResult> shown;
  for (const DriftInput& input : inputs)
    results.attempt(input.path, [&] { measure_one(core, request, gsl, input, shown, results); });
  if (!request.page.empty())
    results.attempt_after([&] {
      std::vector<std::string> command{"drift"};
      for (const std::string& path : request.files) command.push_back(as_argument(path));
      command.insert(command.end(), {"--report", request.page});
      write_result_page(request.page, program_command(command), shown);
    });
  if (request.printing.is_json) print_json(results.take_json("runs"), 4);
  return results.exit_code();
}

void declare(Options& options, DriftRequest& request) {
  options.files(request.files,
                {"SCENARIO or RUN.h5", "",
                 "scenario files, folders of them, or trajectories; - for a scenario on standard input"},
                1, -1);
  declare_reference(options, request.reference);
  options.text(request.output,
               {"-o,--output", "FILE.h5", "write the trajectory with the groups /reference and /drift"});
  options.flag(request.stores_rows, {"--rows", "", "with -o: store the errors of every row as well"});
  options.text(request.figures,
               {"--figures", "DIR", "draw the distance from the exact fling, and energy drift by cause"});
  options.text(request.page,
               {"--report", "FILE.html", "write that picture, the figures and their tables as a page"});
  options.printing(request.printing, "print all arcs and contacts");
}

}  // namespace

Command drift_command() {
  return {.name = "drift",
          .summary = "measure runs against the exact flight between contacts: errors and energy",
          .example =
              "hyrax-sim drift scenarios/flings/first-fling.json\n"
              "  hyrax-sim drift first-fling.h5 --figures pictures",
          .is_common = true,
          .needs_paper_step = true,
          .declare = with_request<DriftRequest>(declare, drift)};
}

}  // namespace hyrax

#include "sim/core/core.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/drift/drift.h"
#include "tools/app/library/run_flow.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/table_text.h"
#include "tools/platform/path.h"
#include "tools/report/page_file.h"
#include "tools/run_core/run_core.h"
#include "tools/store/csv_file.h"

namespace hyrax {
namespace {

struct PaperRunRequest : RunRequest {
  ReferenceRequest reference{.name = "closed", .stepper = "", .tolerance = {}};
  bool stores_rows = false;
  bool computes_all = false;
};

std::optional<DriftOptions> stored_drift(const Core& core, const PaperRunRequest& request) {
  if (request.measures_drift) require_paper_core(core, "hyrax-sim run: --drift");
  if (request.measures_drift)
    return DriftOptions{.gsl = gsl_options(request.reference, "hyrax-sim run"),
                        .encloses = request.printing.is_json,
                        .stores_rows = request.stores_rows};
  if (request.stores_rows || request.reference.is_given())
    refuse_input("hyrax-sim run: --rows, --reference, --stepper and --tolerance need --drift");
  return std::nullopt;
}

void report(const Core& core, const PaperRunRequest& request, const ScenarioRun& run,
            CommandResults& results) {
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

void write_page(const Core& core, const PaperRunRequest& request, const ScenarioRun& run) {
  write_report(core, {.files = {run.output},
                      .against = run.comparison ? run.golden_path : "",
                      .output = request.page,
                      .command = page_command(request, {run.path})});
  print_written(request, request.page);
}

// The runs of several scenarios, with a sheet of them and of those that failed.
void write_sheet(const Core& core, const PaperRunRequest& request, const ReportRequest& runs,
                 const std::vector<RunPanel>& panels) {
  ReportRequest page = runs;
  page.output = request.page;
  page.command = page_command(request, request.files);
  page.panels = panels;
  write_report(core, page);
}

RunPanel run_one(const Core& own_core, const PaperRunRequest& request,
                 const std::optional<DriftOptions>& drift, const std::string& path, const Scenario& scenario,
                 const std::string& output, CommandResults& results, ReportRequest& runs) {
  const Core core = run_core(own_core, path, scenario);
  if (drift) require_paper_core(core, path + ": --drift");
  require_measurable(core, path, scenario);
  std::optional<RunPicture> picture;
  if (!request.figure.empty() || request.shows_sheet) picture.emplace(scenario);
  const ScenarioRun run =
      run_scenario(core, path, scenario, output,
                   {.golden_folder = request.golden_folder,
                    .skips_repetition = !request.computes_all,
                    .compares = request.overrides.empty(),
                    .drift = drift,
                    .measures_start = request.printing.is_verbose() && !drift &&
                                      is_measurable(core.constants, reference_model(core)),
                    .picture = picture ? &*picture : nullptr});
  if (run.drift) results.add(drift_exit_code(*run.drift));
  if (!run.is_as_expected()) results.add(ExitCode::disagreed);
  report(core, request, run, results);
  if (run.drift) results.attempt_after([&] { require_reached(*run.drift); }, path);
  if (request.shows_sheet) {
    const std::string link = "#run=" + std::to_string(runs.files.size());
    runs.files.push_back(run.output);
    runs.goldens.push_back(run.comparison ? run.golden_path : "");
    return {.name = scenario.name, .status = run.status(), .picture = picture->panel(scenario), .link = link};
  }
  if (!request.page.empty()) results.attempt_after([&] { write_page(own_core, request, run); }, path);
  if (picture)
    results.attempt_after([&] {
      picture->draw(request.figure, run);
      if (run.output != kStandardOutput) print_written(request, request.figure);
    });
  return {};
}

ExitCode run(const Core& core, PaperRunRequest request) {
  if (!request.page.empty() && file_name(request.output).extension == ".csv")
    refuse_input("hyrax-sim run: --report: not possible with a CSV file (found " + request.output +
                 "); allowed: .h5");
  std::optional<DriftOptions> drift;
  ReportRequest runs;
  const auto load = [&](const std::string& path, const std::vector<Override>& overrides) {
    const Scenario scenario = load_scenario(path, overrides);
    return LoadedScenario{scenario.name, [&, path, scenario](const std::string& output, auto& results) {
                            return run_one(core, request, drift, path, scenario, output, results, runs);
                          }};
  };
  const auto require = [&](const std::vector<std::string>& outputs) {
    for (const std::string& output : outputs)
      if (request.stores_rows && file_name(output).extension == ".csv")
        refuse_input("hyrax-sim run: --rows: not possible in a CSV file (found " + output +
                     "); allowed: .h5");
    if (!request.page.empty()) require_page();
    drift = stored_drift(core, request);
  };
  return run_scenarios(request, load, {require, [&](const std::vector<RunPanel>& panels) {
                                         write_sheet(core, request, runs, panels);
                                       }});
}

void declare(Options& options, PaperRunRequest& request) {
  declare_run(options, request, "draw window, path and contacts to scale; of several scenarios a sheet",
              "write a page that replays the run, or several with a sheet of them, in the browser");
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
          .declare = with_request<PaperRunRequest>(declare, run)};
}

}  // namespace hyrax

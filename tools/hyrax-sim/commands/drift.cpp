#include <fmt/format.h>

#include <memory>

#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/drift/drift.h"
#include "tools/hyrax-sim/golden/golden_check.h"
#include "tools/hyrax-sim/runs/scenario_run.h"
#include "tools/store/output_guard.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

struct DriftRequest {
  std::vector<std::string> files;
  ReferenceRequest reference{.name = "gsl", .stepper = "", .tolerance = {}};
  std::string output;
  std::string figures;
  bool stores_rows = false;
  Printing printing;
};

// A scenario or trajectory file that was read, or why it was not.
struct DriftInput {
  std::string path;
  bool is_file = false;  // A trajectory file.
  std::optional<Scenario> scenario;
  std::optional<Failure> failure;
};

DriftInput read_input(const std::string& path) {
  DriftInput input{path, is_trajectory(path), {}, {}};
  try {
    input.scenario = input.is_file ? TrajectoryFile::open(path).head().scenario : load_scenario(path);
  } catch (const Failure& failure) {
    input.failure = failure;
  }
  return input;
}

class Measurer {
 public:
  explicit Measurer(const DriftRequest& request)
      : request_(request), gsl_(gsl_options(request.reference, "hyrax-sim drift")) {}

  ExitCode measure(const std::vector<DriftInput>& inputs) {
    for (const DriftInput& input : inputs) {
      try {
        if (input.failure) throw *input.failure;
        measure_one(input);
      } catch (const Failure& failure) {
        report_failure(input.path, failure);
      }
    }
    if (request_.printing.is_json)
      print_text("{}\n", to_text(Json::Object{{"runs", std::move(entries_)}}, {.depth_indented = 4}));
    return exit_code_;
  }

 private:
  void measure_one(const DriftInput& input) {
    const DriftOptions options{.gsl = gsl_, .keeps_rows = !request_.figures.empty()};
    DriftReport report{.run = measure_run(input, options), .has_rows_stored = request_.stores_rows};
    report.step_ns = step_ns(report.run.scenario);
    report.half_dt = measure_half_dt(report.run.scenario);
    exit_code_ = more_serious(exit_code_, drift_exit_code(report.run.summary));
    print(input.path, report);
    if (!request_.figures.empty()) draw(report.run);
  }

  // A failure is added to the entry of the run, which is reported already.
  void draw(const DriftRun& run) try {
    const auto files = draw_drift_figures(
        request_.figures, {run.scenario, run.simulated_s, run.summary, run.arcs, run.contacts, run.rows});
    if (!request_.printing.is_json)
      for (const std::string& file : files) print_error("written: " + file);
  } catch (const Failure& failure) {
    exit_code_ = more_serious(exit_code_, failure.exit_code());
    print_error(failure.what());
    if (request_.printing.is_json) {
      Json::Object& entry = *entries_.back().get<Json::Object>();
      entry.emplace_back("status", "failed");
      entry.emplace_back("error", failure.what());
    }
  }

  [[nodiscard]] DriftRun measure_run(const DriftInput& input, const DriftOptions& options) const {
    if (request_.output.empty())
      return measure_drift(
          input.is_file ? load_rows(input.path) : rows_of(*input.scenario, play(*input.scenario)), options);
    if (input.is_file)
      throw Failure(ExitCode::bad_input, input.path + ": is a trajectory; -o needs a scenario");
    return *write_run(request_.output, *input.scenario,
                      {.replay = {}, .drift = StoredDrift{options, request_.stores_rows}})
                .drift;
  }

  void print(const std::string& path, const DriftReport& report) {
    if (!request_.printing.is_json) return print_drift(report, request_.printing);
    Json::Object entry{{"scenario", path}};
    for (auto& member : drift_json(report)) entry.push_back(std::move(member));
    entries_.emplace_back(std::move(entry));
  }

  void report_failure(const std::string& path, const Failure& failure) {
    exit_code_ = more_serious(exit_code_, failure.exit_code());
    print_error(failure.what());
    entries_.push_back(Json::Object{{"scenario", path}, {"status", "failed"}, {"error", failure.what()}});
  }

  const DriftRequest& request_;
  std::optional<GslOptions> gsl_;
  Json::Array entries_;
  ExitCode exit_code_ = ExitCode::agreed;
};

void admit_outputs(const DriftRequest& request, const std::vector<std::string>& paths,
                   const std::vector<DriftInput>& inputs) {
  OutputGuard guard(paths);
  if (!request.output.empty()) guard.admit("hyrax-sim drift: -o", request.output, {".h5"});
  if (request.figures.empty()) return;
  for (const DriftInput& input : inputs)
    if (input.scenario)
      for (const std::string& figure : drift_figure_paths(request.figures, input.scenario->name))
        guard.admit("hyrax-sim drift: --figures of " + input.path, figure);
}

ExitCode drift(const DriftRequest& request) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  if (request.stores_rows && request.output.empty())
    throw Failure(ExitCode::bad_input, "hyrax-sim drift: --rows: needs -o FILE.h5");
  if (!request.output.empty() && paths.size() > 1)
    throw Failure(ExitCode::bad_input,
                  fmt::format("hyrax-sim drift: -o: allowed for one scenario only (found {}); for several: "
                              "hyrax-sim run --drift -o DIR",
                              paths.size()));
  Measurer measurer(request);
  std::vector<DriftInput> inputs;
  for (const std::string& path : paths) inputs.push_back(read_input(path));
  admit_outputs(request, paths, inputs);
  return measurer.measure(inputs);
}

}  // namespace

Command drift_command() {
  return {
      .name = "drift",
      .summary = "measure runs against the exact flight between contacts: errors and energy",
      .example =
          "hyrax-sim drift scenarios/flings/first-fling.json\n"
          "  hyrax-sim drift first-fling.h5 --figures pictures",
      .is_common = true,
      .declare = [](Options& options) {
        const auto request = std::make_shared<DriftRequest>();
        options.files(
            request->files,
            {"SCENARIO or RUN.h5", "",
             "scenario files, folders of them, or trajectories; - for a\nscenario on standard input"},
            1, -1);
        declare_reference(options, request->reference);
        options.text(request->output, {"-o,--output", "FILE.h5",
                                       "write the trajectory with the groups /reference and /drift"});
        options.flag(request->stores_rows, {"--rows", "", "with -o: store the errors of every row as well"});
        options.text(
            request->figures,
            {"--figures", "DIR", "draw energy, its drift, the errors and restitution (needs gnuplot)"});
        options.printing(request->printing);
        return [request] { return drift(*request); };
      }};
}

}  // namespace hyrax

#include <fmt/format.h>

#include <memory>

#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/hyrax-sim/commands/commands.h"
#include "tools/hyrax-sim/drift/drift_options.h"
#include "tools/hyrax-sim/drift/drift_report.h"
#include "tools/hyrax-sim/runs/written_run.h"
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
  bool is_json = false;
};

class Measurer {
 public:
  explicit Measurer(const DriftRequest& request)
      : request_(request), gsl_(gsl_options(request.reference, "hyrax-sim drift")) {}

  ExitCode measure(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      try {
        measure_one(path);
      } catch (const Failure& failure) {
        report_failure(path, failure);
      }
    }
    if (request_.is_json)
      print_text("{}\n", to_text(Json::Object{{"runs", std::move(entries_)}}, {.depth_indented = 4}));
    return exit_code_;
  }

 private:
  void measure_one(const std::string& path) {
    const DriftOptions options{.gsl = gsl_, .keeps_rows = !request_.figures.empty()};
    DriftReport report{.run = request_.output.empty() ? measure_drift(load_rows(path), options)
                                                      : measure_into_file(path, options),
                       .has_rows_stored = request_.stores_rows};
    report.step_ns = step_ns(report.run.scenario);
    report.half_dt = measure_half_dt(report.run.scenario);
    exit_code_ = more_serious(exit_code_, drift_exit_code(report.run.summary));
    tell(path, report);
    if (!request_.figures.empty()) draw(report.run);
  }

  // The run is measured and reported; that its figures are missing is added to its entry.
  void draw(const DriftRun& run) try {
    const auto files = draw_drift_figures(
        request_.figures, {run.scenario, run.simulated_s, run.summary, run.arcs, run.contacts, run.rows});
    if (!request_.is_json)
      for (const std::string& file : files) print_error("drawn " + file);
  } catch (const Failure& failure) {
    exit_code_ = more_serious(exit_code_, failure.exit_code());
    print_error(failure.what());
    if (request_.is_json) {
      Json::Object& entry = *entries_.back().get<Json::Object>();
      entry.emplace_back("status", "failed");
      entry.emplace_back("error", failure.what());
    }
  }

  [[nodiscard]] DriftRun measure_into_file(const std::string& path, const DriftOptions& options) const {
    if (is_trajectory(path))
      throw Failure(ExitCode::bad_input,
                    path + ": -o plays a scenario into a file; name the scenario instead of its trajectory");
    WrittenRun written = write_run(request_.output, load_scenario(path),
                                   {.replay = {}, .drift = StoredDrift{options, request_.stores_rows}});
    return *std::move(written.drift);
  }

  void tell(const std::string& path, const DriftReport& report) {
    if (request_.is_json) {
      Json::Object entry{{"scenario", path}};
      for (auto& member : drift_json(report)) entry.push_back(std::move(member));
      entries_.emplace_back(std::move(entry));
    } else {
      print_text("{}", drift_text(report));
    }
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

// Nothing where it cannot be read, which is reported when it is measured.
std::optional<std::string> name_in(const std::string& path) try {
  return is_trajectory(path) ? TrajectoryFile::open(path).head().scenario.name : load_scenario(path).name;
} catch (const Failure&) {
  return std::nullopt;
}

void admit_outputs(const DriftRequest& request, const std::vector<std::string>& paths) {
  OutputGuard guard(paths);
  if (!request.output.empty()) guard.admit("hyrax-sim drift: -o", request.output, {".h5"});
  if (request.figures.empty()) return;
  for (const std::string& path : paths)
    if (const auto name = name_in(path))
      for (const std::string& figure : drift_figure_paths(request.figures, *name))
        guard.admit("hyrax-sim drift: --figures of " + path, figure);
}

ExitCode drift(const DriftRequest& request) {
  const std::vector<std::string> paths = list_scenarios(request.files);
  if (request.stores_rows && request.output.empty())
    throw Failure(ExitCode::bad_input,
                  "hyrax-sim drift: --rows stores errors in a file; say with -o in which");
  if (!request.output.empty() && paths.size() > 1)
    throw Failure(ExitCode::bad_input,
                  fmt::format("hyrax-sim drift: -o writes one run, {} are given; `hyrax-sim "
                              "run --drift -o DIR` writes several",
                              paths.size()));
  Measurer measurer(request);
  admit_outputs(request, paths);
  return measurer.measure(paths);
}

}  // namespace

Command drift_command() {
  return {.name = "drift",
          .summary = "measure runs against the exact flight between contacts: errors and energy",
          .example =
              "hyrax-sim drift scenarios/flings/first-fling.json\n"
              "  hyrax-sim drift first-fling.h5 --figures pictures",
          .is_common = true,
          .declare = [](Options& options) {
            const auto request = std::make_shared<DriftRequest>();
            options.files(request->files,
                          {"SCENARIO or RUN.h5", "", "scenarios, folders of them, or trajectories"}, 1, -1);
            declare_reference(options, request->reference);
            options.text(request->output, {"-o,--output", "FILE.h5",
                                           "writes the trajectory with the groups /reference and /drift"});
            options.flag(request->stores_rows, {"--rows", "", "with -o: the errors of every row, too"});
            options.text(
                request->figures,
                {"--figures", "DIR", "draws energy, its drift, the errors and restitution (needs gnuplot)"});
            options.flag(request->is_json, {"--json", "", "one JSON document instead of the table"});
            return [request] { return drift(*request); };
          }};
}

}  // namespace hyrax

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tools/files/path.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/commands.h"
#include "tools/hyrax-sim/drift_options.h"
#include "tools/hyrax-sim/drift_report.h"
#include "tools/hyrax-sim/print.h"
#include "tools/hyrax-sim/run_picture.h"
#include "tools/hyrax-sim/run_report.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct RunRequest {
  std::vector<std::string> files;
  std::string output;
  std::vector<std::string> overrides;
  std::string figure;
  std::string golden_folder;
  ReferenceRequest reference{.name = "closed", .stepper = "", .tolerance = {}};
  bool measures_drift = false;
  bool stores_rows = false;
  bool computes_all = false;
  bool is_json = false;
};

// A scenario that was read, or why it was not.
struct Candidate {
  std::string path;
  std::optional<Scenario> scenario;
  std::string output;
  std::optional<Failure> failure;
};

std::vector<Override> overrides_of(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || !text.starts_with('/'))
      throw Failure(ExitCode::bad_input,
                    "hyrax-sim run: --set: not POINTER=VALUE (found " + text + "); as in /clock/rate_hz=144");
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

Candidate read_candidate(const std::string& path, const std::vector<Override>& overrides) {
  Candidate candidate;
  candidate.path = path;
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

// Where each run is to be written.
void place_outputs(const RunRequest& request, OutputGuard& guard, std::vector<Candidate>& candidates) {
  for (Candidate& candidate : candidates) {
    if (!candidate.scenario) continue;
    const std::string name = candidate.scenario->name + ".h5";
    if (request.output.empty())
      candidate.output = name;
    else
      candidate.output = writes_into_folder(request, candidates.size())
                             ? (fs::path(request.output) / name).string()
                             : request.output;
    guard.admit("hyrax-sim run: -o of " + candidate.path, candidate.output, {".h5", ".csv"});
    if (request.stores_rows && file_name(candidate.output).extension == ".csv")
      throw Failure(ExitCode::bad_input, "hyrax-sim run: --rows: not possible in a CSV file (found " +
                                             candidate.output + "); allowed: .h5");
  }
}

void make_output_folder(const RunRequest& request, std::size_t scenarios) {
  if (request.output.empty() || !writes_into_folder(request, scenarios)) return;
  std::error_code error;
  fs::create_directories(request.output, error);
  if (error)
    throw Failure(ExitCode::cannot_access, request.output + ": cannot be created: " + error.message());
}

std::optional<StoredDrift> stored_drift(const RunRequest& request) {
  if (request.measures_drift)
    return StoredDrift{{.gsl = gsl_options(request.reference, "hyrax-sim run")}, request.stores_rows};
  if (request.stores_rows || request.reference.is_given())
    throw Failure(
        ExitCode::bad_input,
        "hyrax-sim run: --rows, --reference, --stepper and --tolerance say how to measure; add --drift");
  return std::nullopt;
}

class Runner {
 public:
  explicit Runner(const RunRequest& request) : request_(request), drift_(stored_drift(request)) {}

  ExitCode run(const std::vector<Candidate>& candidates) {
    for (const Candidate& candidate : candidates) {
      try {
        if (candidate.failure) throw *candidate.failure;
        run_one(candidate);
      } catch (const Failure& failure) {
        report_failure(candidate.path, failure);
      }
    }
    if (request_.is_json)
      print_text("{}\n", to_text(Json::Object{{"runs", std::move(entries_)}}, {.depth_indented = 3}));
    return exit_code_;
  }

 private:
  void run_one(const Candidate& candidate) {
    const ScenarioRun run = run_scenario(candidate.path, *candidate.scenario, candidate.output,
                                         {.golden_folder = request_.golden_folder,
                                          .skips_repetition = !request_.computes_all,
                                          .compares = request_.overrides.empty(),
                                          .drift = drift_});
    if (run.drift) exit_code_ = more_serious(exit_code_, drift_exit_code(run.drift->summary));
    if (!run.is_as_expected()) exit_code_ = more_serious(exit_code_, ExitCode::disagreed);
    report(run);
    if (!request_.figure.empty()) draw(*candidate.scenario);
  }

  // The run is written and reported; that its figure is missing is added to its entry.
  void draw(const Scenario& scenario) try {
    draw_run(request_.figure, scenario);
    if (!request_.is_json) print_text("  drawn          {}\n", request_.figure);
  } catch (const Failure& failure) {
    exit_code_ = more_serious(exit_code_, failure.exit_code());
    print_error(failure.what());
    if (!request_.is_json) return;
    Json::Object& entry = *entries_.back().get<Json::Object>();
    for (auto& [key, value] : entry)
      if (key == "status") value = "failed";
    entry.emplace_back("error", failure.what());
  }

  void report(const ScenarioRun& run) {
    DriftReport drift;
    if (run.drift) drift = {.run = *run.drift, .has_rows_stored = request_.stores_rows};
    if (!request_.is_json) {
      print_text("{}{}", run_text(run), run.drift ? drift_text(drift) : "");
      return;
    }
    Json entry = run_json(run);
    if (run.drift) entry.get<Json::Object>()->emplace_back("drift", drift_json(drift));
    entries_.push_back(std::move(entry));
  }

  void report_failure(const std::string& path, const Failure& failure) {
    exit_code_ = more_serious(exit_code_, failure.exit_code());
    print_error(failure.what());
    entries_.push_back(Json::Object{{"scenario", path}, {"status", "failed"}, {"error", failure.what()}});
  }

  const RunRequest& request_;
  std::optional<StoredDrift> drift_;
  Json::Array entries_;
  ExitCode exit_code_ = ExitCode::agreed;
};

ExitCode run(const RunRequest& request) {
  const std::vector<Override> overrides = overrides_of(request.overrides);
  const std::vector<std::string> paths = list_scenarios(request.files);
  if (!request.figure.empty() && paths.size() > 1)
    throw Failure(ExitCode::bad_input, "hyrax-sim run: --figure draws one scenario, " +
                                           std::to_string(paths.size()) + " are given");
  std::vector<Candidate> candidates;
  for (const std::string& path : paths) candidates.push_back(read_candidate(path, overrides));
  OutputGuard guard(paths, request.golden_folder);
  place_outputs(request, guard, candidates);
  if (!request.figure.empty()) guard.admit("hyrax-sim run: --figure", request.figure, {".svg"});
  Runner runner(request);
  if (std::any_of(candidates.begin(), candidates.end(), [](const auto& each) { return each.scenario; }))
    make_output_folder(request, candidates.size());
  return runner.run(candidates);
}

}  // namespace

Command run_command() {
  return {.name = "run",
          .summary = "replay scenarios, write their trajectories and compare them with golden files",
          .example =
              "hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
              "  hyrax-sim run scenarios/flings/first-fling.json --set /clock/rate_hz=144 -o at-144-hz.h5",
          .is_common = true,
          .declare = [](Options& options) {
            const auto request = std::make_shared<RunRequest>();
            options.files(request->files, {"SCENARIO", "", "scenario files, or folders of them"}, 1, -1);
            options.text(request->output, {"-o,--output", "FILE or DIR",
                                           "FILE.h5, FILE.csv or a folder; NAME.h5 "
                                           "in this folder if left out"});
            options.texts(request->overrides,
                          {"--set", "POINTER=VALUE", "replaces a value of the file, by JSON Pointer"});
            options.text(request->figure, {"--figure", "FILE.svg",
                                           "draws window, path and contacts to scale (needs gnuplot)"});
            options.text(request->golden_folder,
                         {"--golden", "DIR", "golden files; the `golden` beside `scenarios` if left out"});
            options.flag(request->measures_drift,
                         {"--drift", "", "measure it against the reference, as the command `drift` does"});
            options.flag(request->stores_rows, {"--rows", "", "with --drift: store the errors of every row"});
            declare_reference(options, request->reference);
            options.flag(request->computes_all, {"--no-skip", "", "compute steps that repeat exactly, too"});
            options.flag(request->is_json, {"--json", "", "one JSON document instead of the table"});
            return [request] { return run(*request); };
          }};
}

}  // namespace hyrax

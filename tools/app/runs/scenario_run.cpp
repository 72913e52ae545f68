#include "tools/app/runs/scenario_run.h"

#include <algorithm>

#include "sim/reference/drift_meter.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/study/reference_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/play/play_with_progress.h"
#include "tools/files/path.h"
#include "tools/files/text_file.h"
#include "tools/report/run_scene.h"
#include "tools/store/drift_tables.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

void append(std::vector<RowSink*>& sinks, const std::vector<RowSink*>& others) {
  sinks.insert(sinks.end(), others.begin(), others.end());
}

// Measures a run as it is written, and adds the result to its file.
class StoredErrors {
 public:
  StoredErrors(hid_t file, const Scenario& scenario, std::int64_t steps, const StoredDrift& stored)
      : reference_(h5::create_group(file, "reference")), drift_(h5::create_group(file, "drift")) {
    DriftOptions options = stored.options;
    if (stored.stores_rows) options.also = &rows_.emplace(reference_, drift_, steps, scenario.record_every);
    recorder_.emplace(scenario, options);
  }

  [[nodiscard]] std::vector<RowSink*> sinks() { return recorder_->sinks(); }
  /// False if the result could not be written.
  [[nodiscard]] bool finish(hid_t file, const RunSummary& summary, DriftRun& run) {
    run = recorder_->finish(summary.steps, summary.simulated_s);
    const bool has_rows = !rows_ || rows_->finish(file);
    const bool has_arcs = write_measured_arcs(reference_, drift_, run);
    reference_ = {};
    drift_ = {};
    return has_rows && has_arcs;
  }

 private:
  h5::Handle reference_;
  h5::Handle drift_;
  std::optional<DriftRowTable> rows_;
  std::optional<DriftRecorder> recorder_;
};

// `steps` is less than the scenario's if a first try found that the run ends there.
WrittenRun write_trajectory(const Core& core, const std::string& output, const Scenario& scenario,
                            std::int64_t steps, const WriteOptions& options) {
  TrajectoryWriter writer(output, scenario, steps);
  std::vector<RowSink*> sinks = {&writer};
  append(sinks, options.also);
  std::optional<StoredErrors> errors;
  if (options.drift) append(sinks, errors.emplace(writer.file(), scenario, steps, *options.drift).sinks());
  WrittenRun run;
  run.summary = play_with_progress(core, scenario, sinks, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  if (run.summary.steps != steps) return run;
  std::function<bool(hid_t)> write_more;
  if (errors) write_more = [&](hid_t file) { return errors->finish(file, run.summary, run.drift.emplace()); };
  writer.finish({scenario, steps, std::string(core.name), hex(run.summary.state_hash), core.constants},
                inputs_of(scenario, steps), run.summary.contacts.total(), write_more);
  return run;
}

WrittenRun write_csv(const Core& core, const std::string& output, const Scenario& scenario,
                     const WriteOptions& options) {
  TrajectoryCsv csv(output, scenario, step_count(scenario));
  std::vector<RowSink*> sinks = {&csv};
  append(sinks, options.also);
  std::optional<DriftRecorder> drift;
  if (options.drift) append(sinks, drift.emplace(scenario, options.drift->options).sinks());
  WrittenRun run;
  run.summary = play_with_progress(core, scenario, sinks, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  csv.finish();
  if (drift) run.drift = drift->finish(run.summary.steps, run.summary.simulated_s);
  return run;
}

constexpr std::int64_t kRowsDrawnFirst = 50'000;

}  // namespace

WrittenRun write_run(const Core& core, const std::string& output, const Scenario& scenario,
                     const WriteOptions& options) {
  if (output == kStandardOutput || file_name(output).extension == ".csv")
    return write_csv(core, output, scenario, options);
  const std::int64_t steps = step_count(scenario);
  WrittenRun run = write_trajectory(core, output, scenario, steps, options);
  if (run.summary.steps == steps) return run;
  // A run that becomes non-finite is shorter than its file was made for.
  WriteOptions again = options;
  again.also.clear();
  return write_trajectory(core, output, scenario, run.summary.steps, again);
}

bool ScenarioRun::is_as_expected() const {
  return std::ranges::all_of(expectations, &Expectation::holds) && !summary.non_finite_step &&
         (!comparison || comparison->agrees);
}

const char* ScenarioRun::status() const {
  if (!is_as_expected()) return "disagreed";
  return comparison || !expectations.empty() ? "agreed" : "played";
}

ScenarioRun run_scenario(const Core& core, const std::string& path, const Scenario& scenario,
                         const std::string& output, const ScenarioRunOptions& options) {
  const bool measures = scenario.expect && bounds_errors(*scenario.expect) && !options.drift;
  DriftSink ignored;
  const Model model = reference_model(core);
  DriftMeter meter(scenario, inputs_of(scenario, step_count(scenario)), ignored, nullptr, model);
  std::vector<RowSink*> also;
  if (options.picture != nullptr) also.push_back(options.picture);
  if (measures) also.push_back(&meter);
  std::optional<MarginMeter> margin;
  if (options.measures_start)
    also.push_back(&margin.emplace(scenario, inputs_of(scenario, step_count(scenario)), model));
  ReplayOptions replay = judged_options(scenario);
  replay.skips_repetition = options.skips_repetition;
  ScenarioRun run;
  run.path = path;
  run.scenario = scenario;
  run.output = output;
  const auto place = golden_place(path, options.golden_folder);
  if (path == "-")
    run.not_compared = "standard input";
  else if (!place)
    run.not_compared = "no folder `scenarios` above it; --golden DIR names one";
  else if (!options.compares)
    run.not_compared = "values were set";
  if (run.not_compared.empty()) {
    run.golden_path = place->h5_path;
    run.golden_folder = options.golden_folder;
    if (has_golden_file(*place))
      run.comparison = compare_with_pair(core, scenario, *place, true, core)->comparison;
    else if (is_there(place->h5_path))
      run.golden_path = place->txt_path;
  }
  static_cast<WrittenRun&>(run) =
      write_run(core, output, scenario, {.replay = replay, .drift = options.drift, .also = also});
  if (margin) run.start = {margin->margin(), contact_chance_of(core, scenario, margin->margin())};
  run.expectations = judge_run(core, scenario, run.summary,
                               run.drift  ? std::optional(run.drift->summary)
                               : measures ? std::optional(meter.finish())
                                          : std::nullopt);
  return run;
}

RunPicture::RunPicture(const Scenario& scenario) : rows_every_(1 + step_count(scenario) / kRowsDrawnFirst) {}

RowSink::Wants RunPicture::wants() const {
  return {.rows_every = rows_every_, .all_rows_to = kRowsDrawnFirst, .contacts = true};
}

void RunPicture::contact_began(const Contact& contact) {
  if (contacts_.size() < kBouncesShownMax) contacts_.push_back(contact);
}

void RunPicture::draw(const std::string& path, const ScenarioRun& run) const {
  write_text_file(path, run_svg(run.scenario, rows_, contacts_, run.summary.contacts));
}

}  // namespace hyrax

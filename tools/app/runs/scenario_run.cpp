#include "tools/app/runs/scenario_run.h"

#include <algorithm>

#include "sim/reference/drift_meter.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/study/reference_model.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/play/play.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/drift_tables.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

WrittenRun play_into(RowSink& file, const Core& core, const Scenario& scenario, const WriteOptions& options,
                     std::optional<DriftRecorder>& drift) {
  std::vector<RowSink*> sinks = options.also;
  sinks.push_back(&file);
  if (drift)
    for (RowSink* const sink : drift->sinks()) sinks.push_back(sink);
  WrittenRun run;
  run.summary = play_with_progress(core, scenario, sinks, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  return run;
}

// `steps` is less than the scenario's if a first try found that the run ends there.
WrittenRun write_trajectory(const Core& core, const std::string& output, const Scenario& scenario,
                            std::int64_t steps, const WriteOptions& options) {
  TrajectoryWriter writer(output, scenario, steps);
  h5::Handle reference, drift;
  std::optional<DriftRowTable> rows;
  std::optional<DriftRecorder> recorder;
  if (options.drift) {
    reference = h5::create_group(writer.file(), "reference");
    drift = h5::create_group(writer.file(), "drift");
    if (options.drift->stores_rows) rows.emplace(reference, drift, steps, scenario.record_every);
    recorder.emplace(scenario, reference_model(core), *options.drift, rows ? &*rows : nullptr);
  }
  WrittenRun run = play_into(writer, core, scenario, options, recorder);
  if (run.summary.steps != steps) return run;
  const auto write_errors = [&](hid_t file) {
    if (!recorder) return true;
    run.drift = recorder->finish(steps, run.summary.simulated_s);
    const bool has_rows = !rows || rows->finish(file);
    const bool has_arcs = write_measured_arcs(reference, drift, *run.drift);
    reference = {};
    drift = {};
    return has_rows && has_arcs;
  };
  writer.finish({{steps, std::string(core.name), hex(run.summary.state_hash), core.constants,
                  core.record.checksum(), core.walls_of_rows},
                 scenario},
                inputs_of(scenario, steps), run.summary.contacts.total(), write_errors);
  return run;
}

WrittenRun write_csv(const Core& core, const std::string& output, const Scenario& scenario,
                     const WriteOptions& options) {
  TrajectoryCsv csv(output, scenario, step_count(scenario));
  std::optional<DriftRecorder> drift;
  if (options.drift) drift.emplace(scenario, reference_model(core), *options.drift);
  WrittenRun run = play_into(csv, core, scenario, options, drift);
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
  const bool is_golden_missing = !golden_path.empty() && !comparison;
  return comparison || (!expectations.empty() && !is_golden_missing) ? "agreed" : "played";
}

ScenarioRun run_scenario(const Core& core, const std::string& path, const Scenario& scenario,
                         const std::string& output, const ScenarioRunOptions& options) {
  const bool measures = scenario.expect && bounds_errors(*scenario.expect) && !options.drift;
  DriftSink ignored;
  const Model model = reference_model(core);
  std::optional<DriftMeter> meter;
  std::vector<RowSink*> also;
  if (options.picture != nullptr) also.push_back(options.picture);
  if (measures)
    also.push_back(
        &meter.emplace(scenario, inputs_of(scenario, step_count(scenario)), ignored, nullptr, model));
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
  if (margin) run.start = margin->margin();
  run.expectations = judge_run(core, scenario, run.summary,
                               run.drift  ? std::optional(run.drift->summary)
                               : measures ? std::optional(meter->finish())
                                          : std::nullopt);
  return run;
}

RunPicture::RunPicture(const Scenario& scenario) : rows_every_(1 + step_count(scenario) / kRowsDrawnFirst) {}

RowSink::Wants RunPicture::wants() const {
  return {.rows_every = rows_every_, .all_rows_to = kRowsDrawnFirst, .contacts = true};
}

void RunPicture::contact_began(const Contact& contact) {
  if (contacts_.size() < kTouchesShownMax) contacts_.push_back(contact);
}

void RunPicture::draw(const std::string& path, const ScenarioRun& run) const {
  write_text_file(path, run_svg(run.scenario, rows_, contacts_, run.summary.bounces));
}

}  // namespace hyrax

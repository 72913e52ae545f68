#include "tools/hyrax-sim/written_run.h"

#include <fmt/format.h>

#include "sim/scenario/frame_clock.h"
#include "tools/files/path.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/shown_replay.h"
#include "tools/store/drift_tables.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

RunSummary play_with_progress(const Scenario& scenario, RowSink& sink, const ReplayOptions& options) {
  Replay replay(scenario, sink, options);
  play_shown(replay, replay.steps());
  return replay.finish();
}

std::string checked_by(const std::optional<GslOptions>& gsl) {
  if (!gsl) return "nothing";
  return fmt::format("GSL {}, tolerance {:g}", kGslStepperNames[static_cast<std::size_t>(gsl->stepper)],
                     gsl->tolerance);
}

// Measures the rows, and adds to the file what comes of it; false where that could not be written.
bool write_drift(hid_t file, const RunRows& rows, const StoredDrift& stored, DriftRun& run) {
  const h5::Handle reference = h5::create_group(file, "reference");
  const h5::Handle drift = h5::create_group(file, "drift");
  DriftOptions options = stored.options;
  std::optional<DriftRowTable> table;
  if (stored.stores_rows)
    options.also = &table.emplace(reference, drift, rows.steps, rows.scenario.record_every);
  run = measure_drift(rows, options);
  const bool has_rows = !table || table->finish(file);
  return write_measured_arcs(reference, drift, {run.summary, run.arcs, run.contacts, checked_by(run.gsl)}) &&
         has_rows;
}

// `steps` is shorter than the scenario where an earlier try found that the run ends there.
WrittenRun play_into(const std::string& output, const Scenario& scenario, std::int64_t steps,
                     const WriteOptions& options) {
  TrajectoryWriter writer(output, scenario, steps);
  WrittenRun run;
  run.summary = play_with_progress(scenario, writer, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  if (run.summary.steps != steps) return run;
  std::int64_t contacts = 0;
  for (const std::int64_t count : run.summary.contacts) contacts += count;
  std::function<bool(hid_t)> write_more;
  if (options.drift)
    write_more = [&](hid_t file) {
      return write_drift(file, rows_of(scenario, run.summary), *options.drift, run.drift.emplace());
    };
  writer.finish({scenario, steps, std::string(kPhysicsModel), hex(run.summary.state_hash)},
                inputs_taken(scenario, steps), contacts, write_more);
  return run;
}

WrittenRun write_csv(const std::string& output, const Scenario& scenario, const WriteOptions& options) {
  TrajectoryCsv csv(output, scenario.record_every);
  WrittenRun run;
  run.summary = play_with_progress(scenario, csv, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  csv.finish();
  if (options.drift) run.drift = measure_drift(rows_of(scenario, run.summary), options.drift->options);
  return run;
}

}  // namespace

WrittenRun write_run(const std::string& output, const Scenario& scenario, const WriteOptions& options) {
  if (file_name(output).extension == ".csv") return write_csv(output, scenario, options);
  const std::int64_t steps = step_count(scenario);
  WrittenRun run = play_into(output, scenario, steps, options);
  return run.summary.steps == steps ? run : play_into(output, scenario, run.summary.steps, options);
}

}  // namespace hyrax

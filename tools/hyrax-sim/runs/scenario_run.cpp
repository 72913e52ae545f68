#include "tools/hyrax-sim/runs/scenario_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "sim/scenario/frame_clock.h"
#include "tools/files/file_name.h"
#include "tools/hyrax-sim/golden/golden_pair.h"
#include "tools/hyrax-sim/runs/run_rows.h"
#include "tools/report/run_figure.h"
#include "tools/store/drift_arc_table.h"
#include "tools/store/drift_row_table.h"
#include "tools/store/trajectory_csv.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

RunSummary play_into(const Scenario& scenario, RowSink& sink, const ReplayOptions& options) {
  Replay replay(scenario, sink, options);
  play_with_progress(replay, replay.steps());
  return replay.finish();
}

std::string checked_by(const std::optional<GslOptions>& gsl) {
  if (!gsl) return "nothing";
  return fmt::format("GSL {}, tolerance {:g}", kGslStepperNames[static_cast<std::size_t>(gsl->stepper)],
                     gsl->tolerance);
}

// Measures the rows and adds the result to the file; false if that could not be written.
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

// `steps` is less than the scenario's if a first try found that the run ends there.
WrittenRun write_trajectory(const std::string& output, const Scenario& scenario, std::int64_t steps,
                            const WriteOptions& options) {
  TrajectoryWriter writer(output, scenario, steps);
  WrittenRun run;
  run.summary = play_into(scenario, writer, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  if (run.summary.steps != steps) return run;
  std::function<bool(hid_t)> write_more;
  if (options.drift)
    write_more = [&](hid_t file) {
      return write_drift(file, rows_of(scenario, run.summary), *options.drift, run.drift.emplace());
    };
  writer.finish({scenario, steps, std::string(kPhysicsModel), hex(run.summary.state_hash)},
                inputs_taken(scenario, steps), run.summary.contacts.total(), write_more);
  return run;
}

WrittenRun write_csv(const std::string& output, const Scenario& scenario, const WriteOptions& options) {
  TrajectoryCsv csv(output, scenario.record_every);
  WrittenRun run;
  run.summary = play_into(scenario, csv, options.replay);
  run.rows_recorded = TrajectoryWriter::row_count(run.summary.steps, scenario.record_every);
  csv.finish();
  if (options.drift) run.drift = measure_drift(rows_of(scenario, run.summary), options.drift->options);
  return run;
}

constexpr std::int64_t kRowsDrawnFirst = 50'000;
constexpr std::size_t kContactsDrawnMax = 100;

// Keeps every K-th row after a step, and the first contacts.
class PictureSink : public RowSink {
 public:
  PictureSink(std::int64_t rows_every, std::int64_t after_step)
      : rows_every_(rows_every), after_step_(after_step) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = true}; }
  void rows(const Columns& batch) override {
    for (std::size_t index = 0; index < batch.size(); ++index)
      if (batch.step[index] > after_step_) kept.append(batch.row(index));
  }
  void contact_began(const Contact& contact) override {
    if (contacts.size() < kContactsDrawnMax) contacts.push_back(contact);
  }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    if (static_cast<std::size_t>(index) < contacts.size())
      contacts[static_cast<std::size_t>(index)].last_step = last_step;
  }

  Columns kept;
  std::vector<Contact> contacts;

 private:
  std::int64_t rows_every_;
  std::int64_t after_step_;
};

std::optional<double> value_of(const std::optional<Worst>& worst) {
  return worst ? std::optional(worst->value) : std::nullopt;
}

}  // namespace

WrittenRun write_run(const std::string& output, const Scenario& scenario, const WriteOptions& options) {
  if (file_name(output).extension == ".csv") return write_csv(output, scenario, options);
  const std::int64_t steps = step_count(scenario);
  WrittenRun run = write_trajectory(output, scenario, steps, options);
  return run.summary.steps == steps ? run : write_trajectory(output, scenario, run.summary.steps, options);
}

std::vector<Expectation> judge_run(const Scenario& scenario, const RunSummary& summary) {
  if (!scenario.expect) return {};
  if (!bounds_errors(*scenario.expect)) return judge(*scenario.expect, summary);
  const DriftSummary drift = summarize_drift(rows_of(scenario, summary));
  return judge(*scenario.expect, summary,
               RunErrors{value_of(drift.implementation_px), value_of(drift.truncation_px),
                         value_of(drift.energy_drift_rel_max)});
}

bool ScenarioRun::is_as_expected() const {
  const bool all_hold =
      std::all_of(expectations.begin(), expectations.end(), [](const auto& e) { return e.holds; });
  return all_hold && !summary.non_finite_step && (!comparison || comparison->agrees);
}

ScenarioRun run_scenario(const std::string& path, const Scenario& scenario, const std::string& output,
                         const ScenarioRunOptions& options) {
  const bool checks_bounds = scenario.expect && scenario.expect->in_bounds;
  ScenarioRun run;
  static_cast<WrittenRun&>(run) =
      write_run(output, scenario,
                {.replay = {.skips_repetition = options.skips_repetition, .checks_bounds = checks_bounds},
                 .drift = options.drift});
  run.path = path;
  run.scenario = scenario;
  run.output = output;
  run.expectations = judge_run(scenario, run.summary);
  const auto place = golden_place(path, options.golden_folder);
  if (path == "-")
    run.not_compared = "standard input";
  else if (!place)
    run.not_compared = "no folder `scenarios` above it; --golden DIR names one";
  else if (!options.compares)
    run.not_compared = "values were set";
  if (!run.not_compared.empty()) return run;
  run.golden_path = place->h5_path;
  run.golden_folder = options.golden_folder;
  if (has_golden_file(*place)) run.comparison = compare_with_pair(scenario, *place, true)->comparison;
  return run;
}

void draw_run(const std::string& path, const Scenario& scenario) {
  PictureSink sink(1, -1);
  Replay beginning(scenario, sink);
  const std::int64_t steps = beginning.steps();
  beginning.play_to(std::min(steps, kRowsDrawnFirst));
  WallCounts contacts = beginning.finish().contacts;
  if (steps > kRowsDrawnFirst) {
    PictureSink others(1 + steps / kRowsDrawnFirst, kRowsDrawnFirst);
    contacts = replay(scenario, others).contacts;
    for (std::size_t index = 0; index < others.kept.size(); ++index) sink.kept.append(others.kept.row(index));
    sink.contacts = std::move(others.contacts);
  }
  draw_run_figure(path, scenario, sink.kept, sink.contacts, contacts);
}

}  // namespace hyrax

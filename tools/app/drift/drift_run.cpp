#include "tools/app/core/core_requirements.h"
#include "tools/app/drift/drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "sim/core/listing_core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/physics_model.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

void read_into(const TrajectoryFile& file, const std::vector<RowSink*>& sinks) {
  constexpr std::int64_t kBatchRows = 1 << 16;
  const std::int64_t count = file.row_count();
  for (std::int64_t first = 0; first < count; first += kBatchRows) {
    const Columns rows = file.rows(first, std::min(kBatchRows, count - first));
    for (std::size_t index = 0; index < rows.size(); ++index)
      if (rows.step[index] != first + static_cast<std::int64_t>(index))
        file.refuse(fmt::format("/trajectory/step: must be {} (found {})",
                                first + static_cast<std::int64_t>(index), rows.step[index]));
    for (RowSink* const sink : sinks) sink->rows(rows);
  }
}

// Twice the frames, and twice the frame numbers of events; a hitch keeps its dt.
std::optional<Scenario> at_half_dt(Scenario scenario) {
  const std::int64_t steps = step_count(scenario);
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  if (auto* rate = std::get_if<FixedRate>(&scenario.clock.base)) {
    rate->rate_hz *= 2.0;
    if (rate->rate_hz > kRateMax_hz) return std::nullopt;
  } else {
    std::get<FixedStep>(scenario.clock.base).dt_s *= 0.5;
  }
  scenario.length = 2 * steps;
  for (std::size_t event = 0; event < frames.size(); ++event) scenario.events[event].when = 2 * frames[event];
  return scenario;
}

}  // namespace

DriftRecorder::DriftRecorder(const Scenario& scenario, const Model& model, const DriftOptions& options,
                             DriftSink* row_sink)
    : keeps_rows_(options.keeps_rows),
      row_sink_(row_sink),
      solver_(options.gsl ? gsl_flight(*options.gsl, model) : nullptr),
      meter_(scenario, inputs_of(scenario, step_count(scenario)), *this, solver_.get(), model),
      margin_(scenario, inputs_of(scenario, step_count(scenario)), model),
      whole_(
          scenario, inputs_of(scenario, step_count(scenario)), model,
          options.keeps_rows ? std::function([this](const WholeRow& row) { whole_rows_.add(row); }) : nullptr,
          options.encloses) {
  run_.scenario = scenario;
  run_.model = model;
  run_.is_checked_by_default = !options.gsl || *options.gsl == GslOptions{};
  if (options.gsl)
    run_.checked_by =
        fmt::format("GSL {}, tolerance {:g}",
                    kGslStepperNames[static_cast<std::size_t>(options.gsl->stepper)], options.gsl->tolerance);
}

void DriftRecorder::row(const RowErrors& row) {
  if (keeps_rows_) rows_.add({arcs_seen_, row});
  if (row_sink_ != nullptr) row_sink_->row(row);
}

void DriftRecorder::arc(const ArcErrors& arc) {
  ++arcs_seen_;
  if (!run_.longest_arc || arc.duration_s > run_.longest_arc->duration_s) run_.longest_arc = arc;
  if (run_.arcs.size() < kArcsListedMax) run_.arcs.push_back(arc);
}

void DriftRecorder::contact(const ImpactErrors& contact) {
  if (run_.contacts.size() < kArcsListedMax) run_.contacts.push_back(contact);
}

DriftRun DriftRecorder::finish(std::int64_t steps, double simulated_s) {
  run_.steps = steps;
  run_.simulated_s = simulated_s;
  run_.summary = meter_.finish();
  run_.margin = margin_.margin();
  run_.whole = whole_.finish();
  if (run_.whole.run) run_.whole.run->secular_px_per_s = run_.summary.secular_px_per_s;
  return std::move(run_);
}

DriftRun measure_drift(const Core& core, const Scenario& scenario, const DriftOptions& options) {
  DriftRecorder recorder(scenario, reference_model(core), options);
  const RunSummary summary = play_with_progress(core, scenario, recorder.sinks());
  return recorder.finish(summary.steps, summary.simulated_s);
}

Core core_of_file(const Core& core, const std::string& path, const FileHead& head) {
  if (!head.constants)
    refuse_input(path + ": needs the paper's step, with any constants (found the core " + head.physics +
                 ", whose step is another)");
  if (const auto played = with_parameters(core, head.scenario.parameters);
      played && is_same_model(head.physics, core.name) && played->constants &&
      numbers_of(*head.constants) == numbers_of(*played->constants))
    return *played;
  Core other = listing_core(*head.constants);
  other.name = head.physics;
  other.parameters = head.scenario.parameters;
  require_paper_core(other, path);
  return other;
}

DriftRun load_drift(const Core& core, const std::string& path, const DriftOptions& options) {
  const TrajectoryFile file = TrajectoryFile::open(path);
  const FileHead& head = file.head();
  DriftRecorder recorder(head.scenario, reference_model(core), options);
  if (file.holds_every_row()) {
    read_into(file, recorder.sinks());
    return recorder.finish(head.steps, file.rows(head.steps, 1).t_s.front());
  }
  const RunSummary summary = play_with_progress(core, head.scenario, recorder.sinks());
  DriftRun run = recorder.finish(summary.steps, summary.simulated_s);
  run.note = fmt::format("replayed from its scenario: the file holds {} of {} rows", file.row_count(),
                         head.steps + 1);
  if (hex(summary.state_hash) != head.state_hash) run.note += "; THE REPLAY'S STATE HASH DIFFERS";
  return run;
}

void declare_reference(Options& options, ReferenceRequest& request) {
  options.choice(request.name,
                 {"--reference", "closed|gsl",
                  "the closed form alone, or checked by GSL (default: " + request.name + ")"},
                 {"closed", "gsl"});
  options.choice(request.stepper, {"--stepper", "NAME", "the stepper of GSL (default: rk8pd)"},
                 {kGslStepperNames.begin(), kGslStepperNames.end()});
  options.number(request.tolerance,
                 {"--tolerance", "X", "absolute and relative tolerance of GSL (default: 1e-12)"},
                 kGslToleranceMin);
}

std::optional<GslOptions> gsl_options(const ReferenceRequest& request, const std::string& command) {
  if (request.name != "gsl") {
    if (!request.stepper.empty() || request.tolerance)
      refuse_input(command + ": --stepper and --tolerance need --reference gsl");
    return std::nullopt;
  }
  GslOptions options;
  if (!request.stepper.empty()) {
    const auto name = std::find(kGslStepperNames.begin(), kGslStepperNames.end(), request.stepper);
    options.stepper = static_cast<GslStepper>(name - kGslStepperNames.begin());
  }
  options.tolerance = request.tolerance.value_or(options.tolerance);
  if (options.tolerance > kGslToleranceMax)
    refuse_input(fmt::format("{}: --tolerance: must be at most {:g} (found {:g})", command, kGslToleranceMax,
                             options.tolerance));
  return options;
}

ExitCode drift_exit_code(const DriftRun& run) {
  const DriftSummary& summary = run.summary;
  if (run.whole.is_fault || (summary.reference_faults > 0 && run.is_checked_by_default))
    return ExitCode::program_fault;
  const bool holds = !summary.non_finite_step && summary.differing_steps == 0;
  return holds ? ExitCode::agreed : ExitCode::disagreed;
}

HalfDt measure_half_dt(const Core& core, const Scenario& scenario) {
  constexpr std::int64_t kStepsMaxHere = 1'000'000;
  if (scenario.clock.jitter) return {.why_not = "jitter"};
  if (std::holds_alternative<RecordedSteps>(scenario.clock.base)) return {.why_not = "a trace"};
  const std::int64_t steps = step_count(scenario);
  if (steps == 0 || base_dt_s(scenario.clock) == 0.0) return {.why_not = "dt is 0"};
  if (steps > kStepsMaxHere) return {.why_not = "over 1e6 steps"};
  const std::optional<Scenario> halved = at_half_dt(scenario);
  if (!halved) return {.why_not = "no such clock"};
  return {.run = measure_drift(core, *halved)};
}

}  // namespace hyrax

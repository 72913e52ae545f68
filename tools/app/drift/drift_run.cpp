#include "tools/app/core/paper_model.h"
#include "tools/app/drift/drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sim/core/listing_core.h"
#include "sim/reference/drift_meter.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/physics_model.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

// At most kRowsDrawnMax of many values: at the limit every other one is dropped, and from then on half as
// many are added.
template <class Value>
class Thinned {
 public:
  explicit Thinned(std::vector<Value>& values) : values_(values) {}
  void add(const Value& value) {
    if (seen_++ % every_ != 0) return;
    values_.push_back(value);
    if (values_.size() < kRowsDrawnMax) return;
    for (std::size_t index = 0; 2 * index < values_.size(); ++index) values_[index] = values_[2 * index];
    values_.resize((values_.size() + 1) / 2);
    every_ *= 2;
  }

 private:
  std::vector<Value>& values_;
  std::int64_t seen_ = 0;
  std::int64_t every_ = 1;
};

class Recorder final : public DriftSink {
 public:
  Recorder(DriftRun& run, const DriftOptions& options)
      : run_(run), rows_(run.rows), keeps_rows_(options.keeps_rows), also_(options.also) {
    also_wants_rows_ = also_ != nullptr && also_->wants_rows();
  }

  [[nodiscard]] bool wants_rows() const override { return keeps_rows_ || also_wants_rows_; }
  void row(const RowErrors& row) override {
    if (keeps_rows_) rows_.add({arcs_seen_, row});
    if (also_wants_rows_) also_->row(row);
  }
  void arc(const ArcErrors& arc) override {
    ++arcs_seen_;
    if (!run_.longest_arc || arc.duration_s > run_.longest_arc->duration_s) run_.longest_arc = arc;
    if (run_.arcs.size() < kArcsListedMax) run_.arcs.push_back(arc);
    if (also_ != nullptr) also_->arc(arc);
  }
  void contact(const ImpactErrors& contact) override {
    if (run_.contacts.size() < kArcsListedMax) run_.contacts.push_back(contact);
    if (also_ != nullptr) also_->contact(contact);
  }

 private:
  DriftRun& run_;
  Thinned<DrawnRow> rows_;
  bool keeps_rows_;
  DriftSink* also_;
  bool also_wants_rows_ = false;
  std::size_t arcs_seen_ = 0;
};

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

}  // namespace

struct DriftRecorder::Sinks {
  Sinks(const Scenario& scenario, const DriftOptions& options)
      : solver(options.gsl ? gsl_flight(*options.gsl, options.model) : nullptr),
        recorder(run, options),
        meter(scenario, inputs_of(scenario, step_count(scenario)), recorder, solver.get(), options.model),
        margin(scenario, inputs_of(scenario, step_count(scenario)), options.model),
        whole_rows(run.whole_rows),
        whole(scenario, inputs_of(scenario, step_count(scenario)), options.model,
              options.keeps_rows ? std::function([this](const WholeRow& row) { whole_rows.add(row); })
                                 : nullptr) {
    run.scenario = scenario;
    if (options.gsl)
      run.checked_by = fmt::format("GSL {}, tolerance {:g}",
                                   kGslStepperNames[static_cast<std::size_t>(options.gsl->stepper)],
                                   options.gsl->tolerance);
    run.model = options.model;
  }

  DriftRun run;
  std::unique_ptr<FlightSolver> solver;
  Recorder recorder;
  DriftMeter meter;
  MarginMeter margin;
  Thinned<WholeRow> whole_rows;
  WholeMeter whole;
};

DriftRecorder::DriftRecorder(const Scenario& scenario, const DriftOptions& options)
    : sinks_(std::make_unique<Sinks>(scenario, options)) {}
DriftRecorder::~DriftRecorder() = default;

std::vector<RowSink*> DriftRecorder::sinks() { return {&sinks_->meter, &sinks_->margin, &sinks_->whole}; }

DriftRun DriftRecorder::finish(std::int64_t steps, double simulated_s) {
  DriftRun& run = sinks_->run;
  run.steps = steps;
  run.simulated_s = simulated_s;
  run.summary = sinks_->meter.finish();
  run.margin = sinks_->margin.margin();
  run.whole = sinks_->whole.outcome();
  if (run.whole.run) run.whole.run->secular_px_per_s = run.summary.secular_px_per_s;
  return std::move(run);
}

DriftRun measure_drift(const Core& core, const Scenario& scenario, DriftOptions options) {
  options.model = reference_model(core);
  DriftRecorder recorder(scenario, options);
  const RunSummary summary = play_with_progress(core, scenario, recorder.sinks());
  return recorder.finish(summary.steps, summary.simulated_s);
}

Core core_of_file(const Core& core, const std::string& path, const FileHead& head) {
  if (!head.constants)
    refuse_input(path + ": needs the paper's step, with any constants (found the core " + head.physics +
                 ", whose step is another)");
  if (is_same_model(head.physics, core.name) && core.constants &&
      numbers_of(*head.constants) == numbers_of(*core.constants))
    return core;
  Core other = listing_core(*head.constants);
  other.name = head.physics;
  require_paper_core(other, path);
  return other;
}

DriftRun load_drift(const Core& core, const std::string& path, DriftOptions options) {
  const TrajectoryFile file = TrajectoryFile::open(path);
  const FileHead& head = file.head();
  options.model = reference_model(core);
  DriftRecorder recorder(head.scenario, options);
  if (file.row_count() == head.steps + 1) {
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

ExitCode drift_exit_code(const DriftSummary& summary) {
  if (summary.reference_faults > 0) return ExitCode::program_fault;
  const bool holds = !summary.non_finite_step && summary.differing_steps == 0;
  return holds ? ExitCode::agreed : ExitCode::disagreed;
}

}  // namespace hyrax

#include "tools/hyrax-sim/drift/drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "sim/reference/drift_meter.h"

namespace hyrax {
namespace {

class Recorder final : public DriftSink {
 public:
  Recorder(DriftRun& run, const DriftOptions& options)
      : run_(run), keeps_rows_(options.keeps_rows), also_(options.also) {
    also_wants_rows_ = also_ != nullptr && also_->wants_rows();
  }

  [[nodiscard]] bool wants_rows() const override { return keeps_rows_ || also_wants_rows_; }
  void row(const RowErrors& row) override {
    if (keeps_rows_ && rows_seen_++ % rows_every_ == 0) keep(row);
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
  // At the limit, every other row is dropped, and from then on half as many are added.
  void keep(const RowErrors& row) {
    std::vector<DrawnRow>& rows = run_.rows;
    rows.push_back({arcs_seen_, row});
    if (rows.size() < kRowsDrawnMax) return;
    for (std::size_t index = 0; 2 * index < rows.size(); ++index) rows[index] = rows[2 * index];
    rows.resize((rows.size() + 1) / 2);
    rows_every_ *= 2;
  }

  DriftRun& run_;
  bool keeps_rows_;
  DriftSink* also_;
  bool also_wants_rows_ = false;
  std::size_t arcs_seen_ = 0;
  std::int64_t rows_seen_ = 0;
  std::int64_t rows_every_ = 1;
};

DriftSummary measure_to(const RunRows& rows, std::int64_t last_step, DriftSink& sink, FlightSolver* solver) {
  DriftMeter meter(rows.scenario, rows.inputs, sink, solver);
  rows.send_to(meter, last_step);
  return meter.finish();
}

// A row from which the run consists of complete periods; nothing if skipping them saves no time.
std::optional<std::int64_t> start_of_whole_periods(const RunRows& rows) {
  if (!rows.repetition) return std::nullopt;
  const auto [from_step, period_steps] = *rows.repetition;
  const std::int64_t begin = from_step + 2 * period_steps;
  const std::int64_t start = begin + (rows.steps - begin) % period_steps;
  constexpr std::int64_t kWorthIt = 100'000;
  if (rows.steps - start < kWorthIt + period_steps) return std::nullopt;
  return start;
}

// If a period has no arc and no contact, but ends an arc that was too short to count, all later periods are
// the same.
DriftSummary measure(const RunRows& rows, DriftSink& sink, FlightSolver* solver) {
  const std::optional<std::int64_t> start = start_of_whole_periods(rows);
  if (!start) return measure_to(rows, rows.steps, sink, solver);
  const std::int64_t period_steps = rows.repetition->period_steps;
  DriftSink ignored;
  const DriftSummary before = measure_to(rows, *start, ignored, nullptr);
  const DriftSummary after = measure_to(rows, *start + period_steps, ignored, nullptr);
  const std::int64_t skipped = after.skipped_arcs - before.skipped_arcs;
  if (after.arcs != before.arcs || after.contacts != before.contacts || skipped == 0)
    return measure_to(rows, rows.steps, sink, solver);
  DriftSummary summary = measure_to(rows, *start, sink, solver);
  summary.skipped_arcs += (rows.steps - *start) / period_steps * skipped;
  return summary;
}

// In a state that repeats, no decision comes nearer except by what a change of the start still moves; in so
// many steps air drag alone reduces that to 2e-9.
constexpr std::int64_t kStepsUntilStartIsForgotten = 20'000;

Margin margin_of(const RunRows& rows) {
  std::int64_t last_step = rows.steps;
  if (rows.repetition)
    last_step = std::min(last_step, rows.repetition->from_step + 2 * rows.repetition->period_steps +
                                        kStepsUntilStartIsForgotten);
  MarginMeter meter(rows.scenario, rows.inputs);
  rows.send_to(meter, last_step);
  return meter.margin();
}

}  // namespace

DriftRun measure_drift(const RunRows& rows, const DriftOptions& options) {
  DriftRun run;
  run.scenario = rows.scenario;
  run.steps = rows.steps;
  run.simulated_s = rows.simulated_s;
  run.note = rows.note;
  run.gsl = options.gsl;
  Recorder recorder(run, options);
  std::unique_ptr<FlightSolver> solver;
  if (options.gsl) solver = std::make_unique<GslFlight>(*options.gsl);
  run.summary = measure(rows, recorder, solver.get());
  run.margin = margin_of(rows);
  return run;
}

DriftSummary summarize_drift(const RunRows& rows) {
  DriftSink ignored;
  return measure(rows, ignored, nullptr);
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
      throw Failure(ExitCode::bad_input, command + ": --stepper and --tolerance need --reference gsl");
    return std::nullopt;
  }
  GslOptions options;
  if (!request.stepper.empty()) {
    const auto name = std::find(kGslStepperNames.begin(), kGslStepperNames.end(), request.stepper);
    options.stepper = static_cast<GslStepper>(name - kGslStepperNames.begin());
  }
  options.tolerance = request.tolerance.value_or(options.tolerance);
  if (options.tolerance > kGslToleranceMax)
    throw Failure(ExitCode::bad_input, fmt::format("{}: --tolerance: must be at most {:g} (found {:g})",
                                                   command, kGslToleranceMax, options.tolerance));
  return options;
}

ExitCode drift_exit_code(const DriftSummary& summary) {
  if (summary.reference_faults > 0) return ExitCode::program_fault;
  return summary.non_finite_step ? ExitCode::disagreed : ExitCode::agreed;
}

}  // namespace hyrax

#include "tools/hyrax-sim/drift/drift_run.h"

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
  // Where it becomes too much, every other row goes, and from then on so many fewer come.
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
  rows.hand_to(meter, last_step);
  return meter.finish();
}

// A row from which the run goes through whole periods only; none where that saves nothing.
std::optional<std::int64_t> start_of_whole_periods(const RunRows& rows) {
  if (!rows.repetition) return std::nullopt;
  const auto [from_step, period_steps] = *rows.repetition;
  const std::int64_t begin = from_step + 2 * period_steps;
  const std::int64_t start = begin + (rows.steps - begin) % period_steps;
  constexpr std::int64_t kWorthIt = 100'000;
  if (rows.steps - start < kWorthIt + period_steps) return std::nullopt;
  return start;
}

// Where a period has no arc and no contact, but ends what might become an arc, the periods to come are
// like it.
DriftSummary measure(const RunRows& rows, DriftSink& sink, FlightSolver* solver) {
  const std::optional<std::int64_t> start = start_of_whole_periods(rows);
  if (!start) return measure_to(rows, rows.steps, sink, solver);
  const std::int64_t period_steps = rows.repetition->period_steps;
  DriftSink nothing;
  const DriftSummary before = measure_to(rows, *start, nothing, nullptr);
  const DriftSummary after = measure_to(rows, *start + period_steps, nothing, nullptr);
  const std::int64_t skipped = after.skipped_arcs - before.skipped_arcs;
  if (after.arcs != before.arcs || after.contacts != before.contacts || skipped == 0)
    return measure_to(rows, rows.steps, sink, solver);
  DriftSummary summary = measure_to(rows, *start, sink, solver);
  summary.skipped_arcs += (rows.steps - *start) / period_steps * skipped;
  return summary;
}

// In a state that repeats no decision comes nearer, but for what a start still moves; air drag alone
// brings that to 2e-9 of itself in so many steps.
constexpr std::int64_t kStepsUntilStartIsForgotten = 20'000;

std::int64_t last_decisive_step(const RunRows& rows) {
  if (!rows.repetition) return rows.steps;
  return std::min(rows.steps, rows.repetition->from_step + 2 * rows.repetition->period_steps +
                                  kStepsUntilStartIsForgotten);
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
  DriftSink nothing;
  return measure(rows, nothing, nullptr);
}

Margin margin_of(const RunRows& rows) {
  MarginMeter meter(rows.scenario, rows.inputs);
  rows.hand_to(meter, last_decisive_step(rows));
  return meter.margin();
}

}  // namespace hyrax

// The errors of a run, measured as its rows arrive.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sim/reference/arc_cutter.h"
#include "sim/reference/arc_meter.h"
#include "sim/reference/drift.h"
#include "sim/reference/flight.h"
#include "sim/reference/model.h"
#include "sim/trajectory/resting_contact.h"

namespace hyrax {

/// Takes every row of a run, live or from a file, and measures its arcs in constant memory. Of a run that
/// repeats itself without an arc it wants no more rows than it takes to see that.
class DriftMeter final : public RowSink {
 public:
  /// @param inputs of the scenario, as they were applied.
  /// @param solver a second solution beside the closed form; null: closed form alone.
  /// Refers to sink and solver.
  DriftMeter(const Scenario& scenario, std::vector<Input> inputs, DriftSink& sink,
             FlightSolver* solver = nullptr, const Model& model = {})
      : meter_(model, sink, solver),
        cutter_(scenario, std::move(inputs), meter_),
        steps_(step_count(scenario)) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = is_over_ ? 0 : 1}; }
  void row(const Row& row) override;
  void repeats(const Repetition& repetition) override;
  /// Ends the run after its last row, and sums up.
  DriftSummary finish();

 private:
  // Complete periods, from row `start` to the run's end.
  struct Periods {
    std::int64_t start = 0;
    std::int64_t steps = 0;
    DriftSummary before = {};  // Of the rows up to the start.
  };

  [[nodiscard]] DriftSummary summary() const;
  void judge_period(std::int64_t step);
  void end_stretch(std::int64_t step);

  ArcMeter meter_;
  ArcCutter cutter_;
  RestingContact resting_;
  double open_from_s_ = 0.0;  // Time of its open_from_step,
  bool has_gone_on_ = false;  // of a rest that goes on.
  std::vector<DriftSummary::Rest> rests_;
  Row last_;
  std::int64_t steps_;
  std::optional<Periods> periods_;
  bool is_over_ = false;  // The periods to come are like one that was measured.
  std::int64_t arcs_skipped_later_ = 0;
};

}  // namespace hyrax

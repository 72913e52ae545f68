// A run in, its errors out.
#pragma once

#include <utility>
#include <vector>

#include "sim/reference/arc_cutter.h"
#include "sim/reference/arc_meter.h"
#include "sim/reference/drift.h"
#include "sim/reference/flight_solver.h"
#include "sim/reference/model.h"

namespace hyrax {

/// Takes every row of a run, live or from a file, and measures its arcs in constant memory.
class DriftMeter final : public RowSink {
 public:
  /// @param inputs of the scenario, as they were applied.
  /// @param solver a second solution beside the closed form; null: closed form alone.
  /// Refers to sink and solver.
  DriftMeter(const Scenario& scenario, std::vector<Input> inputs, DriftSink& sink,
             FlightSolver* solver = nullptr, const Model& model = {})
      : meter_(model, sink, solver), cutter_(scenario, std::move(inputs), meter_) {}

  [[nodiscard]] Wants wants() const override { return cutter_.wants(); }
  void rows(const Columns& batch) override { cutter_.rows(batch); }
  /// Of the rows so far, without the arc that is not over yet.
  [[nodiscard]] DriftSummary summary() const {
    DriftSummary summary = meter_.summary();
    summary.skipped_arcs = cutter_.skipped_arcs();
    summary.non_finite_step = cutter_.non_finite_step();
    return summary;
  }
  /// Ends the run after its last row, and sums up.
  DriftSummary finish() {
    cutter_.finish();
    return summary();
  }

 private:
  ArcMeter meter_;
  ArcCutter cutter_;
};

}  // namespace hyrax

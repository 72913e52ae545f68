#include "sim/reference/drift_meter.h"

#include <utility>

namespace hyrax {

DriftMeter::DriftMeter(const Scenario& scenario, std::vector<Input> inputs, DriftSink& sink,
                       FlightSolver* solver, const Model& model)
    : meter_(model, sink, solver), cutter_(scenario, std::move(inputs), meter_) {}

DriftSummary DriftMeter::finish() {
  cutter_.finish();
  DriftSummary summary = meter_.summary();
  summary.skipped_arcs = cutter_.skipped_arcs();
  summary.non_finite_step = cutter_.non_finite_step();
  return summary;
}

}  // namespace hyrax

// Runs for the reference to measure: the shipped core's, and those of test doubles of its step.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim/core/shipped_core.h"
#include "sim/reference/drift_meter.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {

/// Collects the results of a DriftMeter.
struct Measured : DriftSink {
  explicit Measured(bool wants_all_rows = false) : wants_rows_(wants_all_rows) {}
  [[nodiscard]] bool wants_rows() const override { return wants_rows_; }
  void row(const RowErrors& row) override { rows.push_back(row); }
  void arc(const ArcErrors& arc) override { arcs.push_back(arc); }
  void contact(const ImpactErrors& contact) override { contacts.push_back(contact); }

  std::vector<RowErrors> rows;
  std::vector<ArcErrors> arcs;
  std::vector<ImpactErrors> contacts;
  DriftSummary summary;

 private:
  bool wants_rows_;
};

inline std::vector<Input> inputs_of(const Scenario& scenario) {
  return inputs_of(scenario, step_count(scenario));
}

inline Columns rows_of(const Scenario& scenario) {
  TraceSink trace({.rows_every = 1});
  replay(shipped_core(), scenario, trace);
  Columns rows;
  for (const Row& row : trace.rows()) rows.append(row);
  return rows;
}

inline void measure(const Scenario& scenario, const Columns& rows, Measured& measured,
                    FlightSolver* solver = nullptr, const Model& model = {}) {
  DriftMeter meter(scenario, inputs_of(scenario), measured, solver, model);
  meter.rows(rows);
  measured.summary = meter.finish();
}
inline void measure(const Scenario& scenario, Measured& measured, FlightSolver* solver = nullptr) {
  measure(scenario, rows_of(scenario), measured, solver);
}

/// A fling in a window of 1920 x 1080 px that meets walls, top and ground.
inline Scenario fling() {
  Scenario scenario = fling_at(60.0, 600);
  scenario.start = {100.0, 100.0};
  scenario.start_velocity = {900.0, -1200.0};
  return scenario;
}

/// A flight of `steps` frames in the middle of the largest window, where it meets nothing.
inline Scenario open_sky(const Velocity& velocity, double rate_hz, std::int64_t steps) {
  Scenario scenario = fling_at(rate_hz, steps);
  scenario.window = {1'000'000, 1'000'000};
  scenario.start = {400'000.0, 400'000.0};
  scenario.start_velocity = velocity;
  return scenario;
}

/// One frame of a test double: moves the row's state by its dt.
using StepDouble = std::function<void(Row&)>;

/// The scenario's flight by a test double without walls and events.
inline Columns fly_by(const StepDouble& step, const Scenario& scenario) {
  Row row;
  row.x_px = scenario.start.x_px;
  row.y_px = scenario.start.y_px;
  row.vx_px_per_s = scenario.start_velocity.vx_px_per_s;
  row.vy_px_per_s = scenario.start_velocity.vy_px_per_s;
  Columns rows;
  rows.append(row);
  const FrameClock clock(scenario.clock);
  for (std::int64_t frame = 0; frame < step_count(scenario); ++frame) {
    row.step = frame + 1;
    row.dt_s = clock.dt_s(frame);
    row.t_s += row.dt_s;
    step(row);
    rows.append(row);
  }
  return rows;
}

/// The paper's step in flight, with another drag factor.
inline StepDouble paper_step(double air_drag, double gravity_px_per_s2 = 1200.0) {
  return [=](Row& row) {
    row.vy_px_per_s += gravity_px_per_s2 * row.dt_s;
    row.vx_px_per_s *= air_drag;
    row.vy_px_per_s *= air_drag;
    row.x_px += row.vx_px_per_s * row.dt_s;
    row.y_px += row.vy_px_per_s * row.dt_s;
  };
}

}  // namespace hyrax

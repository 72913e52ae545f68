// The groups /reference and /drift of a trajectory file that was measured against the reference.
//
//   /reference               attributes solution, checked_by
//   /reference/{x,y,vx,vy,energy}                              float64 [N], on request
//   /reference/arcs/{first_step,last_step,...}                 [A]
//   /drift                   attributes steps_astray, reference_faults (int64)
//   /drift/{implementation,truncation,model,energy_drift}      float64 [N], on request
//   /drift/arcs/{first_step,last_step,ended_by,...}            [A], attributes total, skipped (int64)
//   /drift/contacts/{step,wall,...}                            [M], attribute total (int64)
//
// N are the rows of /trajectory, whose step and t are linked into both groups; NaN where no arc of
// two steps or more flies. A row that ends one arc and begins the next, as before an input, holds the
// errors of the one that it ends. A and M count at most 100,000, `total` counts all. What an arc or a
// contact does not have is NaN. Every dataset has units (but numbers of rows and codes) and long_name.
// The columns are those of sim/reference/drift.h, which defines them.
#pragma once

#include <array>
#include <cstdint>

#include "sim/reference/drift.h"

namespace hyrax {

/// A column of doubles: its dataset, its unit, what it is, and where it comes from.
template <class Record>
struct DriftColumn {
  const char* name;
  const char* unit;
  const char* long_name;
  double (*get)(const Record&);
};

// In /reference.
inline constexpr std::array<DriftColumn<RowErrors>, 5> kReferenceRowColumns = {{
    {"x", "px", "left edge by the matched ODE", [](const RowErrors& r) { return r.x_px; }},
    {"y", "px", "top edge by the matched ODE", [](const RowErrors& r) { return r.y_px; }},
    {"vx", "px/s", "velocity to the right by the matched ODE",
     [](const RowErrors& r) { return r.vx_px_per_s; }},
    {"vy", "px/s", "velocity downwards by the matched ODE", [](const RowErrors& r) { return r.vy_px_per_s; }},
    {"energy", "px2/s2", "specific energy of the matched ODE, 0 at rest on the floor",
     [](const RowErrors& r) { return r.energy_px2_per_s2; }},
}};

// In /drift.
inline constexpr std::array<DriftColumn<RowErrors>, 4> kDriftRowColumns = {{
    {"implementation", "px", "distance from the discrete closed form",
     [](const RowErrors& r) { return r.implementation_px; }},
    {"truncation", "px", "distance from the matched ODE", [](const RowErrors& r) { return r.truncation_px; }},
    {"model", "px", "distance from the ODE with the drag rate of 60 Hz",
     [](const RowErrors& r) { return r.model_px; }},
    {"energy_drift", "px2/s2", "specific energy of the run minus the matched ODE's",
     [](const RowErrors& r) { return r.energy_drift_px2_per_s2; }},
}};

}  // namespace hyrax

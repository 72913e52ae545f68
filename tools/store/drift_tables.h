// The groups /reference and /drift of a trajectory file that was measured against the reference.
//
//   /reference               attributes solution, checked_by
//   /reference/{x,y,vx,vy,energy}                              float64 [N], on request
//   /reference/arcs/{first_step,last_step,...}                 [A]
//   /drift                   attributes steps_astray, reference_faults (int64)
//   /drift/{implementation,truncation,model,energy,energy_drift} float64 [N], on request
//   /drift/arcs/{first_step,last_step,ended_by,...}            [A], attributes total, skipped (int64)
//   /drift/contacts/{step,wall,...}                            [M], attribute total (int64)
//
// N is the number of rows of /trajectory, whose step and t are linked into both groups. A row outside of all
// arcs of two steps or more is NaN. A row that ends one arc and begins the next, as before an input, has the
// errors of the arc that it ends. A and M are at most 100,000; `total` counts all. A missing value of an arc
// or a contact is NaN. Every dataset has long_name, and units unless it holds row numbers or codes.
// sim/reference/drift.h defines the columns.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/whole_run.h"
#include "tools/store/hdf5.h"

namespace hyrax {

/// A column of doubles: its dataset, unit and description, and its value in a record.
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
inline constexpr std::array<DriftColumn<RowErrors>, 5> kDriftRowColumns = {{
    {"implementation", "px", "distance from the discrete closed form",
     [](const RowErrors& r) { return r.implementation_px; }},
    {"truncation", "px", "distance from the matched ODE", [](const RowErrors& r) { return r.truncation_px; }},
    {"model", "px", "distance from the ODE with the drag rate of 60 Hz",
     [](const RowErrors& r) { return r.model_px; }},
    {"energy", "px2/s2", "specific energy of the run, 0 at rest on the floor",
     [](const RowErrors& r) { return r.energy_px2_per_s2 + r.energy_drift_px2_per_s2; }},
    {"energy_drift", "px2/s2", "specific energy of the run minus the matched ODE's",
     [](const RowErrors& r) { return r.energy_drift_px2_per_s2; }},
}};

/// The row datasets of /reference and /drift, filled as rows are measured. Memory does not grow with the run.
class DriftRowTable final : public DriftSink {
 public:
  /// @param reference, drift the open groups.
  /// @param steps of the run; the file has every `rows_every`-th row of it, and the last one.
  DriftRowTable(hid_t reference, hid_t drift, std::int64_t steps, std::int64_t rows_every);

  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override;
  /// Fills rows outside of all arcs with NaN, and writes the attributes. Returns false if the file could not
  /// be written.
  /// @param file holds a finished /trajectory.
  [[nodiscard]] bool finish(hid_t file);

 private:
  static constexpr std::size_t kColumns = kReferenceRowColumns.size() + kDriftRowColumns.size();
  using Values = std::array<double, kColumns>;

  void put(const Values& values);
  void fill_up_to(std::int64_t index);
  void flush();

  hid_t reference_;
  hid_t drift_;
  std::int64_t steps_;
  std::int64_t rows_every_;
  std::int64_t rows_;
  std::int64_t next_ = 0;  // Index of the next row in the file.
  std::int64_t flushed_ = 0;
  bool is_written_ = true;
  std::array<std::vector<double>, kColumns> pending_;
  std::array<h5::Handle, kColumns> datasets_;
};

struct MeasuredArcs {
  const DriftSummary& summary;
  const std::vector<ArcErrors>& arcs;         ///< The first of them.
  const std::vector<ImpactErrors>& contacts;  ///< The first of them.
  const WholeOutcome& whole;
  std::string checked_by;  ///< The second solution that the closed form was compared with.
};

/// Writes /reference/arcs, /drift/arcs, /drift/contacts and /drift/whole, and the attributes.
/// @param reference, drift the open groups. Returns false if the file could not be written.
[[nodiscard]] bool write_measured_arcs(hid_t reference, hid_t drift, const MeasuredArcs& measured);

}  // namespace hyrax

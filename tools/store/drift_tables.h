// The groups /reference and /drift of a trajectory file that was measured against the reference.
// sim/reference/README.md describes them, sim/reference/drift_columns.h defines the columns.
//
// The step and t of /trajectory are linked into both groups. A row outside of all arcs of two steps or more
// is NaN; one that ends an arc and begins the next, as before an input, has the errors of the arc that it
// ends.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/reference/drift_columns.h"
#include "sim/reference/drift_run.h"
#include "tools/store/hdf5.h"

namespace hyrax {

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
  void put(const RowErrors& row);
  void fill_up_to(std::int64_t index);
  [[nodiscard]] bool flush();

  hid_t reference_;
  hid_t drift_;
  std::int64_t steps_;
  std::int64_t rows_every_;
  std::int64_t rows_;
  std::int64_t next_ = 0;  // Index of the next row in the file.
  std::vector<RowErrors> pending_;
  std::vector<Column> reference_columns_;
  std::vector<Column> drift_columns_;
  h5::ColumnWriter of_reference_;
  h5::ColumnWriter of_drift_;
};

/// Writes /reference/arcs, /drift/arcs, /drift/contacts and /drift/whole, and the attributes.
/// @param reference, drift the open groups. Returns false if the file could not be written.
[[nodiscard]] bool write_measured_arcs(hid_t reference, hid_t drift, const DriftRun& run);

}  // namespace hyrax

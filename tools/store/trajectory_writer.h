// Writes a run as it is played: to a `hyrax-trajectory/1` file, or as comma-separated values.
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/trajectory/row_sink.h"
#include "tools/platform/atomic_file.h"
#include "tools/store/csv_file.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {

/// Writes every record.every-th row and all contacts. Memory does not grow with the run. The file is at
/// `path` only after finish(). ERRORS: every call may throw Failure(cannot_access) "PATH: cannot be written:
/// REASON".
class TrajectoryWriter : public RowSink {
 public:
  /// @param steps of the run.
  TrajectoryWriter(const std::string& path, const Scenario& scenario, std::int64_t steps);

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = true}; }
  void row(const Row& row) override;
  void contact_began(const Contact& contact) override;
  void contact_ended(std::int64_t index, std::int64_t last_step) override;

  /// For groups that are written as the run is played; whoever makes them closes them before `finish` ends.
  [[nodiscard]] hid_t file() const { return file_; }
  /// @param contacts_total of the run, with those that are not recorded.
  /// @param write_more if set, adds further groups to the complete file; returns false if they could not be
  /// written.
  void finish(const FileHead& head, const std::vector<Input>& inputs, std::int64_t contacts_total,
              const std::function<bool(hid_t file)>& write_more = {});

  /// The number of recorded rows of a run: every K-th, and the last one. REQUIRES: every > 0.
  [[nodiscard]] static std::int64_t row_count(std::int64_t steps, std::int64_t every) {
    assert(every > 0);
    return steps / every + 1 + (steps % every != 0 ? 1 : 0);
  }

 private:
  std::string path_;
  std::int64_t rows_every_;
  AtomicFile target_;
  h5::Handle file_;
  h5::Handle trajectory_;
  h5::Handle contacts_;
  RowTable row_table_;
  ContactTable contact_table_;
};

/// The header "step,t_s,dt_s,x_px,y_px,vx_px_per_s,vy_px_per_s,contact", then every record.every-th row.
/// Numbers are shortest-round-trip; contact has the bits of a trajectory file. Memory does not grow with the
/// run. The file is at `path` only after finish(); kStandardOutput gets rows as they are played. ERRORS:
/// every call may throw Failure(cannot_access) "PATH: cannot be written: REASON".
class TrajectoryCsv : public RowSink {
 public:
  /// @param steps of the run.
  TrajectoryCsv(const std::string& path, const Scenario& scenario, std::int64_t steps);

  [[nodiscard]] Wants wants() const override { return {.rows_every = rows_every_, .contacts = false}; }
  void row(const Row& row) override;
  void finish() { file_.finish(); }

 private:
  std::int64_t rows_every_;
  CsvFile file_;
};

}  // namespace hyrax

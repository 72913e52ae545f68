// A sweep's results in a file of the format `hyrax-ensemble/1`.
//
// /members has a dataset for each number that is kept, /inputs one for each varied key, one row a member.
// Attributes of `/`: format, sweep (its base inside), members, physics, core; of a part also part and parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/result/table.h"
#include "sim/scenario/sweep.h"
#include "tools/files/atomic_file.h"
#include "tools/store/hdf5.h"

namespace hyrax {

/// The groups /members, which has what the sweep keeps, and /inputs, which has what it varies, without rows.
[[nodiscard]] std::vector<Table> ensemble_tables(const Sweep& sweep);
/// Puts the results of a part's rows from `first_row` on in place of theirs.
void set_ensemble_rows(const Sweep& sweep, const WorkPart& part, std::int64_t first_row,
                       std::span<const MemberResult> results, std::vector<Table>& tables);

inline constexpr std::string_view kEnsembleFormat = "hyrax-ensemble/1";

/// What a result file is of.
struct EnsembleHead {
  std::string sweep_text;    ///< As SweepFile::text.
  std::int64_t members = 0;  ///< Of the whole sweep.
  WorkPart part;
  bool is_part = false;      ///< Whether it is a part's file, even of one.
  std::string physics = {};  ///< The model that computed it.
  std::string core = {};     ///< CoreRecord::checksum of the core that did; empty: the file does not say.
};

/// Writes a result file. It is at `path` only after finish(). ERRORS: every call may throw
/// Failure(cannot_access) "PATH: cannot be written: REASON".
class EnsembleWriter {
 public:
  EnsembleWriter(const std::string& path, const EnsembleHead& head, const Sweep& sweep);

  /// Rows that are written.
  [[nodiscard]] std::int64_t rows_done() const { return rows_done_; }
  /// Writes the next rows: tables of ensemble_tables.
  void write(const std::vector<Table>& rows);
  /// REQUIRES: all rows are written.
  void finish();

 private:
  void require(bool is_written) const;

  std::string path_;
  AtomicFile target_;
  h5::Handle file_;
  std::vector<h5::ColumnWriter> groups_;
  std::int64_t rows_done_ = 0;
};

/// Reads a complete result file.
class EnsembleReader {
 public:
  /// ERRORS: Failure(cannot_access) if it cannot be read; Failure(bad_input) if it is no result file of a
  /// sweep, an incomplete one, or damaged.
  explicit EnsembleReader(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const EnsembleHead& head() const { return head_; }
  [[nodiscard]] const Sweep& sweep() const { return sweep_; }
  /// The groups, without rows.
  [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }
  [[nodiscard]] std::int64_t rows() const { return head_.part.rows(head_.members); }
  /// Reads rows of a column into one of tables(), in place of its values.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if an input is not what the sweep says.
  void read(std::size_t table, std::size_t column, std::int64_t first_row, std::int64_t count,
            Column& rows) const;

 private:
  std::string path_;
  EnsembleHead head_;
  Sweep sweep_;
  std::vector<Table> tables_;
  h5::Handle file_;
  std::vector<std::vector<h5::Handle>> datasets_;  // Of each table.
};

}  // namespace hyrax

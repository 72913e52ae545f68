// A sweep's results in a file of the format `hyrax-ensemble/1`.
//
// /members has a dataset for each number that is kept, /inputs one for each varied key, one row a member.
// Attributes of `/`: format, sweep (its base inside), members, physics; of a part also part and parts.
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
#include "tools/store/hdf5.h"

namespace hyrax {

/// The results of a part's rows from `first_row` on, as the groups /members, which has what the sweep keeps,
/// and /inputs, which has what it varies.
[[nodiscard]] std::vector<Table> ensemble_tables(const Sweep& sweep, const WorkPart& part,
                                                 std::int64_t first_row,
                                                 std::span<const MemberResult> results);

inline constexpr std::string_view kEnsembleFormat = "hyrax-ensemble/1";

/// What a result file is of.
struct EnsembleHead {
  std::string sweep_text;    ///< As SweepFile::text.
  std::int64_t members = 0;  ///< Of the whole sweep.
  WorkPart part;
  bool is_part = false;      ///< Whether it is a part's file, even of one.
  std::string physics = {};  ///< The model that computed it.
  bool operator==(const EnsembleHead&) const = default;
};

/// Creates a result file without rows. A file at `path` is replaced.
/// @param result the file that it will be renamed to, which errors of writing name.
/// ERRORS: Failure(cannot_access).
void create_ensemble(const std::string& path, const std::string& result, const EnsembleHead& head,
                     const Sweep& sweep);

/// Writes a result file row by row. What was written survives the end of the process, in whatever way; the
/// bytes of a complete file do not depend on how often it was opened.
class EnsembleWriter {
 public:
  /// Opens a file that is not complete; `result` as of create_ensemble.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if it is no such file, damaged, or of another sweep,
  /// part or physics model.
  EnsembleWriter(const std::string& path, const std::string& result, const EnsembleHead& head,
                 const Sweep& sweep);

  /// Rows that are written.
  [[nodiscard]] std::int64_t rows_done() const { return rows_done_; }
  /// Writes the next rows, as ensemble_tables gives them. ERRORS: Failure(cannot_access).
  void write(const std::vector<Table>& rows);
  /// Marks the file as complete and closes it. REQUIRES: all rows are written. ERRORS:
  /// Failure(cannot_access).
  void finish();

 private:
  void open(const std::string& path, const EnsembleHead& head, const Sweep& sweep);
  [[noreturn]] void fail() const;

  std::string result_;
  h5::Handle file_;
  std::vector<h5::ColumnWriter> groups_;
  h5::Handle done_;  // The attribute that holds rows_done_; not open in a complete file.
  std::int64_t rows_done_ = 0;
};

/// Reads a complete result file.
class EnsembleReader {
 public:
  /// ERRORS: Failure(cannot_access) if it cannot be read; Failure(bad_input) if it is no result file of a
  /// sweep, a partial one, or damaged.
  explicit EnsembleReader(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const EnsembleHead& head() const { return head_; }
  [[nodiscard]] const Sweep& sweep() const { return sweep_; }
  /// The groups, without rows.
  [[nodiscard]] const std::vector<Table>& tables() const { return tables_; }
  [[nodiscard]] std::int64_t rows() const { return head_.part.rows(head_.members); }
  /// Rows of a column.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if an input is not what the sweep says.
  [[nodiscard]] Column read(std::size_t table, std::size_t column, std::int64_t first_row,
                            std::int64_t count) const;

 private:
  std::string path_;
  EnsembleHead head_;
  Sweep sweep_;
  std::vector<Table> tables_;
  h5::Handle file_;
  std::vector<std::vector<h5::Handle>> datasets_;  // Of each table.
};

}  // namespace hyrax

// A sweep's results in a file of the format `hyrax-ensemble/1`.
//
// /members has a dataset for each number that is kept, /inputs one for each varied key, one row a member.
// Attributes of `/`: format, sweep (its base inside), members, physics; of a part also part and parts.
#pragma once

#include <hdf5.h>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/scenario/sweep.h"
#include "tools/store/hdf5.h"

namespace hyrax {

enum class ColumnType : std::uint8_t { real, integer, seed, byte };

/// Rows of a part that are written at once, with their results (which columns of inputs do not need).
struct EnsembleRows {
  const Sweep& sweep;
  WorkPart part;
  std::int64_t first_row = 0;
  std::int64_t count = 0;
  std::span<const MemberResult> results;
};

struct EnsembleColumn {
  std::string group;  ///< "members" or "inputs".
  std::string name;
  std::string unit;  ///< Empty if there is none.
  std::string long_name;
  ColumnType type = ColumnType::real;
  std::size_t width = 1;  ///< Values of a row; a column of more has two dimensions.
  /// Writes the rows' values, in the memory type and row after row.
  std::function<void(const EnsembleRows& rows, std::byte* to)> fill;

  [[nodiscard]] std::string path() const { return group + "/" + name; }
  [[nodiscard]] std::size_t row_bytes() const { return width * (type == ColumnType::byte ? 1 : 8); }
};

/// What the sweep keeps and, after it, what it varies.
[[nodiscard]] std::vector<EnsembleColumn> columns_of(const Sweep& sweep);

[[nodiscard]] hid_t file_type(ColumnType type);
[[nodiscard]] hid_t memory_type(ColumnType type);

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
/// ERRORS: Failure(cannot_access).
void create_ensemble(const std::string& path, const EnsembleHead& head, const Sweep& sweep);

/// Writes a result file row by row. What was written survives the end of the process, in whatever way; the
/// bytes of a complete file do not depend on how often it was opened.
class EnsembleWriter {
 public:
  /// Opens a file that is not complete.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if it is no such file, damaged, or of another sweep,
  /// part or physics model.
  EnsembleWriter(const std::string& path, const EnsembleHead& head, const Sweep& sweep);

  /// Rows that are written.
  [[nodiscard]] std::int64_t rows_done() const { return rows_done_; }
  /// Writes the next rows. ERRORS: Failure(cannot_access).
  void write(const EnsembleRows& rows);
  /// Writes the next rows of all columns from their bytes, as EnsembleReader::read gives them.
  void write(const std::vector<std::vector<std::byte>>& columns, std::int64_t count);
  /// Marks the file as complete and closes it. REQUIRES: all rows are written. ERRORS:
  /// Failure(cannot_access).
  void finish();

 private:
  void open(const EnsembleHead& head);
  [[noreturn]] void fail() const;

  std::string path_;
  std::vector<EnsembleColumn> columns_;
  h5::Handle file_;
  std::vector<h5::Handle> datasets_;
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
  [[nodiscard]] const std::vector<EnsembleColumn>& columns() const { return columns_; }
  [[nodiscard]] std::int64_t rows() const { return head_.part.rows(head_.members); }
  /// Rows of a column, in its memory type.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if an input is not what the sweep says.
  void read(std::size_t column, std::int64_t first_row, std::int64_t count, std::byte* to) const;

 private:
  std::string path_;
  EnsembleHead head_;
  Sweep sweep_;
  std::vector<EnsembleColumn> columns_;
  h5::Handle file_;
  std::vector<h5::Handle> datasets_;
};

}  // namespace hyrax

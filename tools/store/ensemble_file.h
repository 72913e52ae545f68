// A sweep's results in a file of the format `hyrax-ensemble/1`.
//
// /members has a dataset for each number that is kept, /inputs one for each varied key, one row a member.
// Attributes of `/`: format, sweep (its base inside), members, physics, core; of a part also part and parts,
// of a core that describes itself also core_name and description.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/ensemble/ensemble.h"
#include "sim/result/table.h"
#include "sim/scenario/sweep.h"
#include "tools/platform/atomic_file.h"
#include "tools/store/hdf5.h"

namespace hyrax {

/// The group /members, which has what a sweep keeps, without rows.
[[nodiscard]] Table members_table(const KeepSet& keep);
/// Puts results in place of its rows.
void set_members(const KeepSet& keep, std::span<const MemberResult> results, Table& table);
/// The group /inputs, which has what a sweep varies, without rows.
[[nodiscard]] Table inputs_table(const SweepPlan& sweep);
/// Puts the inputs of `count` rows of a part in place of its rows.
void set_inputs(const SweepPlan& sweep, const WorkPart& part, std::int64_t first_row, std::int64_t count,
                Table& table);

inline constexpr std::string_view kEnsembleFormat = "hyrax-ensemble/1";

/// What a result file is of.
struct EnsembleHead {
  std::string sweep_text = {};  ///< As SweepFile::text.
  std::int64_t members = 0;     ///< Of the whole sweep.
  WorkPart part = {};
  bool is_part = false;          ///< Whether it is a part's file, even of one.
  std::string physics = {};      ///< The model that computed it.
  std::string core = {};         ///< CoreRecord::checksum of the core that did; empty: the file does not say.
  std::string core_name = {};    ///< Of a core that describes itself,
  std::string description = {};  ///< and its description, JSON.
};

/// What a result file has.
struct EnsembleContents {
  SweepPlan plan = {};
  std::vector<Table> tables =
      {};  ///< Its groups without rows, each after the one that it is in; last /inputs.
};
/// Finds them. ERRORS: Failure(bad_input) "PATH: ..." if the file is not of this program's kind of core.
using ReadContents = std::function<EnsembleContents(const EnsembleHead& head, const std::string& path)>;
/// Of the paper's interface.
[[nodiscard]] EnsembleContents paper_contents(const EnsembleHead& head, const std::string& path);

/// Writes a result file. It is at `path` only after finish(). ERRORS: every call may throw
/// Failure(cannot_access) "PATH: cannot be written: REASON".
class EnsembleWriter {
 public:
  /// @param tables as EnsembleContents::tables.
  EnsembleWriter(const std::string& path, const EnsembleHead& head, const std::vector<Table>& tables);

  /// Rows that are written.
  [[nodiscard]] std::int64_t rows_done() const { return rows_done_; }
  /// Writes the next `count` rows of all tables.
  void write(const std::vector<Table>& rows, std::int64_t count);
  /// REQUIRES: all rows are written.
  void finish();

 private:
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
  /// sweep, an incomplete one, damaged, or of another kind of core.
  explicit EnsembleReader(const std::string& path, const ReadContents& read_contents = paper_contents);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const EnsembleHead& head() const { return head_; }
  [[nodiscard]] const SweepPlan& plan() const { return contents_.plan; }
  /// The groups, without rows.
  [[nodiscard]] const std::vector<Table>& tables() const { return contents_.tables; }
  [[nodiscard]] std::int64_t rows() const { return head_.part.rows(head_.members); }
  /// Reads rows of a column into one of tables(), in place of its values.
  /// ERRORS: Failure(cannot_access); Failure(bad_input) if an input is not what the sweep says.
  void read(std::size_t table, std::size_t column, std::int64_t first_row, std::int64_t count,
            Column& rows) const;

 private:
  std::string path_;
  EnsembleHead head_;
  EnsembleContents contents_;
  h5::Handle file_;
  std::vector<std::vector<h5::Handle>> datasets_;  // Of each table.
};

}  // namespace hyrax

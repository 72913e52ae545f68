// Files `hyrax-trajectory/1` of a core that describes itself, and comma-separated values.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/described/described_comparison.h"
#include "tools/store/csv_file.h"
#include "tools/store/hdf5.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {

class ValueTable;

/// The attributes of `/`.
struct DescribedHead : RunHead {
  Description description = {};
  DescribedScenario scenario = {};
};

/// Writes every K-th row and the last one, and all contacts. ERRORS: every call may throw
/// Failure(cannot_access) "PATH: cannot be written: REASON".
class DescribedWriter : public DescribedSink {
 public:
  /// @param part_path that is written; `path` is named in messages. The description must outlive this.
  /// @param steps of the run.
  DescribedWriter(const std::string& part_path, const std::string& path, const Description& description,
                  std::int64_t steps, std::int64_t every);
  ~DescribedWriter() override;

  void row(const DescribedRow& row) override;
  void contact(const DescribedContact& contact) override { contacts_.push_back(contact); }

  /// @param contacts_total of the run, with those that are not recorded.
  /// @param blocks of a golden file that does not hold every row; else none.
  void finish(const DescribedHead& head, std::int64_t contacts_total,
              const std::vector<DescribedBlock>& blocks = {});

 private:
  std::string path_;
  const Description& description_;
  std::int64_t steps_;
  std::int64_t every_;
  h5::Handle file_;
  std::unique_ptr<ValueTable> rows_;
  std::vector<DescribedContact> contacts_;
};

/// "step,t_s,dt_s", state, contacts, outputs by name; every K-th row and the last one. Bools, and values with
/// names, are numbers. ERRORS: as CsvFile's.
class DescribedCsv : public DescribedSink {
 public:
  DescribedCsv(const std::string& path, const Description& description, std::int64_t steps,
               std::int64_t every);

  void row(const DescribedRow& row) override;
  void finish() { file_.finish(); }

 private:
  const Description& description_;
  std::int64_t steps_;
  std::int64_t every_;
  CsvFile file_;
};

/// ERRORS: as TrajectoryFile's; Failure(bad_input), too, for a file of another core, with the program that
/// reads it.
class DescribedFile : public RunFile {
 public:
  /// Opens a file of any origin, after reading it in a child process. REQUIRES: as read_isolated.
  [[nodiscard]] static DescribedFile open(const std::string& path, const std::string& core);

  [[nodiscard]] const DescribedHead& head() const { return head_; }
  /// From the first; refers to this.
  [[nodiscard]] DescribedRowBatches rows() const;
  /// Passes them on as a run does, with outputs.
  void show(DescribedSink& sink) const;
  [[nodiscard]] std::vector<DescribedContact> contacts() const;
  /// Of a golden file that does not hold every row; else none.
  [[nodiscard]] std::vector<DescribedBlock> blocks() const;

 private:
  // A dataset of values of a type that only the file knows.
  struct ValueColumn {
    std::int64_t length = 0;
    std::function<void(std::int64_t first, std::int64_t count, std::vector<Word>& words)> read;
  };
  DescribedFile(const std::string& path, const std::string& core, Parsing parsing);

  [[nodiscard]] DescribedHead read_head(const std::string& core, Parsing parsing) const;
  [[nodiscard]] ValueColumn value_column(const std::string& dataset, const ValueInfo& value) const;
  /// All of it. @param length that it must have.
  [[nodiscard]] std::vector<Word> words(const std::string& dataset, const ValueInfo& value,
                                        std::size_t length) const;
  void read_all() const;

  DescribedHead head_;
  NumberColumn<double> t_;
  NumberColumn<double> dt_;
  std::vector<ValueColumn> state_;
  std::vector<ValueColumn> outputs_;
  std::vector<ValueColumn> flags_;
};

/// Rows that a file does not hold are replayed, if it is of this core. Refers to the files.
[[nodiscard]] DescribedComparison compare_files(const DescribedCore& core, const DescribedFile& a,
                                                const DescribedFile& b, const Tolerance& tolerance = {});

}  // namespace hyrax

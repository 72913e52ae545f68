// Errors of rows on their way into a file, beside the rows themselves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tools/store/drift_format.h"
#include "tools/store/hdf5.h"

namespace hyrax {

/// Makes the row datasets of /reference and /drift, and fills them as rows are measured. Memory does
/// not grow with the run.
class DriftRowTable final : public DriftSink {
 public:
  /// @param reference, drift the open groups.
  /// @param steps of the run, of which every `rows_every`-th row is in the file, and the last one.
  DriftRowTable(hid_t reference, hid_t drift, std::int64_t steps, std::int64_t rows_every);

  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override;
  /// Fills up what no arc reached, and describes all. False where the file could not be written.
  /// @param file holds a finished /trajectory.
  [[nodiscard]] bool finish(hid_t file);

 private:
  static constexpr std::size_t kColumns = kReferenceRowColumns.size() + kDriftRowColumns.size();
  using Values = std::array<double, kColumns>;

  void put(const Values& values);
  void put_nothing_up_to(std::int64_t index);
  void flush();

  hid_t reference_;
  hid_t drift_;
  std::int64_t steps_;
  std::int64_t rows_every_;
  std::int64_t rows_;
  std::int64_t next_ = 0;  // Index of the next row in the file.
  std::int64_t flushed_ = 0;
  bool is_written_ = true;
  std::array<std::vector<double>, kColumns> gathered_;
  std::array<h5::Handle, kColumns> datasets_;
};

}  // namespace hyrax

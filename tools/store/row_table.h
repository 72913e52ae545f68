// Rows on their way into a file: columns of a length known beforehand, written in large batches.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/trajectory/columns.h"
#include "tools/store/hdf5.h"

namespace hyrax {

class RowTable {
 public:
  /// Batches smaller than this are gathered before they are written.
  static constexpr std::size_t kBatch = 65536;

  /// Makes the datasets of /trajectory. @param group the open group; @param rows their length.
  RowTable(hid_t group, std::int64_t rows);

  /// Each returns false where the file could not be written.
  [[nodiscard]] bool append(const Columns& rows);
  [[nodiscard]] bool finish();
  void close();

 private:
  [[nodiscard]] bool write(const Columns& rows);
  [[nodiscard]] bool describe(hid_t group) const;

  hid_t group_;
  std::int64_t rows_;
  std::int64_t written_ = 0;
  Columns gathered_;
  h5::Handle step_;
  h5::Handle contact_;
  std::array<h5::Handle, 6> columns_;
};

}  // namespace hyrax

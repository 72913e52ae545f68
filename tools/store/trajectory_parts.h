// The parts of a `hyrax-trajectory/1` file as they are written: rows, contacts, head.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/schedule.h"
#include "tools/store/hdf5.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {

/// The rows of a run, whose number is known beforehand, written in large batches.
class RowTable {
 public:
  /// So many rows are collected before they are written.
  static constexpr std::size_t kBatch = 65536;

  /// Makes the datasets of /trajectory. @param group the open group; @param rows their length.
  RowTable(hid_t group, std::int64_t rows);

  /// Each returns false if the file could not be written.
  [[nodiscard]] bool append(const Row& row);
  /// A large batch at once. REQUIRES: no row was appended before.
  [[nodiscard]] bool write(const Columns& rows);
  [[nodiscard]] bool finish();
  void close() { writer_.close(); }

 private:
  hid_t group_;
  std::int64_t rows_;
  std::int64_t written_ = 0;
  Columns pending_;
  h5::ColumnWriter writer_;
};

/// The contacts of a run, whose number is not known beforehand and which end long after they began. Keeps up
/// to a batch of them in memory; with more, the datasets grow in chunks.
class ContactTable {
 public:
  static constexpr std::size_t kBatch = 4096;

  /// @param group the open group /contacts.
  explicit ContactTable(hid_t group) : group_(group) {}

  /// Each returns false if the file could not be written.
  [[nodiscard]] bool append(const Contact& contact);
  /// REQUIRES: contact `index` was appended.
  [[nodiscard]] bool set_last_step(std::int64_t index, std::int64_t last_step);
  [[nodiscard]] bool finish();
  void close() { writer_.reset(); }

 private:
  [[nodiscard]] bool flush();

  hid_t group_;
  std::vector<Contact> batch_;
  std::int64_t flushed_ = 0;
  std::optional<h5::ColumnWriter> writer_;
};

/// Writes the attributes of `/`, the group /events and the group /provenance.
/// Returns false if the file could not be written.
[[nodiscard]] bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs);

}  // namespace hyrax

// The parts of a `hyrax-trajectory/1` file as they are written: rows, contacts, head.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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
  [[nodiscard]] bool finish();
  void close() { writer_.close(); }

 private:
  [[nodiscard]] bool write();

  hid_t group_;
  std::int64_t rows_;
  std::int64_t written_ = 0;
  Columns pending_;
  std::vector<Column> columns_;  // Have the vectors of `pending_` as long as they are written.
  h5::ColumnWriter writer_;
};

/// The contacts of a run, whose number is not known beforehand and which end long after they began. Keeps up
/// to a batch of them in memory; with more, the datasets grow in chunks.
class ContactTable {
 public:
  static constexpr std::size_t kBatch = 4096;

  /// @param group the open group /contacts.
  explicit ContactTable(hid_t group) : group_(group), columns_(columns_of(kContactColumns, batch_)) {}

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
  std::vector<Column> columns_;
  std::int64_t flushed_ = 0;
  std::optional<h5::ColumnWriter> writer_;
};

/// Which walls' contacts the rows tell: attributes `source_left` ... of the open group /contacts; none where
/// all follow from the step.
void write_sources(hid_t contacts, std::uint8_t walls_of_rows);
[[nodiscard]] std::uint8_t read_sources(hid_t contacts);

/// The attributes of `/`, with the group /provenance. @param name, scenario of the run, as JSON text.
void write_root(hid_t file, const RunHead& head, const std::string& name, const std::string& scenario);

/// Writes the attributes of `/`, the group /events and the group /provenance.
/// Returns false if the file could not be written.
[[nodiscard]] bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs);

}  // namespace hyrax

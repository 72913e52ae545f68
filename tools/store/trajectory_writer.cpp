#include "tools/store/trajectory_writer.h"

#include <algorithm>

#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/table_text.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kRowBytes = 8 + 8 * kRowColumns.size() + 1;      // step, columns, contact.
constexpr std::uint64_t kContactBytes = 8 * std::size(kContactColumns);  // The wall has one byte.

// At most two contacts in each step, in a corner.
std::uint64_t contact_bytes_max(std::int64_t steps) {
  return kContactBytes * static_cast<std::uint64_t>(std::min(2 * steps, kContactsRecordedMax));
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::string& path, const Scenario& scenario, std::int64_t steps)
    : path_(path),
      rows_every_(scenario.record_every),
      target_(path),
      file_(h5::create_file(
          target_.part_path(),
          require_disk_space(path, row_count(steps, rows_every_), kRowBytes) + contact_bytes_max(steps))),
      trajectory_(h5::create_group(file_, "trajectory")),
      contacts_(h5::create_group(file_, "contacts")),
      row_table_(trajectory_, row_count(steps, rows_every_)),
      contact_table_(contacts_) {
  require_written(file_.is_open(), path_);
}

void TrajectoryWriter::row(const Row& row) { require_written(row_table_.append(row), path_); }

void TrajectoryWriter::contact_began(const Contact& contact) {
  require_written(contact_table_.append(contact), path_);
}

void TrajectoryWriter::contact_ended(std::int64_t index, std::int64_t last_step) {
  require_written(contact_table_.set_last_step(index, last_step), path_);
}

void TrajectoryWriter::finish(const FileHead& head, const std::vector<Input>& inputs,
                              std::int64_t contacts_total,
                              const std::function<bool(hid_t file)>& write_more) {
  require_written(row_table_.finish(), path_);
  require_written(contact_table_.finish(), path_);
  h5::write_attribute(contacts_, "total", contacts_total);
  write_sources(contacts_, head.walls_of_rows);
  require_written(write_head(file_, head, inputs), path_);
  if (write_more) require_written(write_more(file_), path_);
  row_table_.close();
  contact_table_.close();
  trajectory_ = {};
  contacts_ = {};
  require_written(file_.close() >= 0, path_);
  target_.commit();
}

TrajectoryCsv::TrajectoryCsv(const std::string& path, const Scenario& scenario, std::int64_t steps)
    : rows_every_(scenario.record_every),
      file_(path, TrajectoryWriter::row_count(steps, rows_every_), kRowColumns.size() + 2) {
  std::string head = "step";
  for (const RowColumn& column : kRowColumns)
    head.append(",").append(
        key_of({.name = column.name, .unit = column.unit, .long_name = "", .values = {}}));
  file_.append(head + ",contact\n");
}

void TrajectoryCsv::row(const Row& row) {
  std::string line = std::to_string(row.step);
  for (const RowColumn& column : kRowColumns) line.append(",").append(to_text(*column.number(row)));
  file_.append(line.append(",").append(std::to_string(row.contact)).append("\n"));
}

}  // namespace hyrax

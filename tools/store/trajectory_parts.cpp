#include "tools/store/trajectory_parts.h"

#include <cassert>

#include "tools/files/scenario_writer.h"
#include "tools/store/input_record.h"
#include "tools/store/provenance.h"

namespace hyrax {
namespace {

template <class Value>
void append_to(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

void append_to(Columns& rows, const Columns& more) {
  append_to(rows.step, more.step);
  append_to(rows.contact, more.contact);
  for (const RowColumn& column : kRowColumns) append_to(rows.*column.also, more.*column.also);
}

// The meaning and unit of a and b depend on the kind.
bool write_inputs(hid_t file, const std::vector<InputRecord>& inputs) {
  const ColumnOf<InputRecord> described[] = {
      {"frame", "", "frame to which the input was applied; it makes row frame + 1", &InputRecord::frame},
      {"kind", "", "kind of the input",
       ColumnOf<InputRecord>::Code{[](const InputRecord& input) { return input.kind; },
                                   {input_kind_names()}}},
      {"a", "", "vx of a fling or release, x of a place, width of a resize, dt of a hitch, or 0 (unused)",
       &InputRecord::a},
      {"b", "", "vy of a fling or release, y of a place, height of a resize, or 0 (unused)", &InputRecord::b},
  };
  const h5::Handle group = h5::create_group(file, "events");
  const std::vector<Column> columns = columns_of(described, inputs);
  h5::ColumnWriter writer(group, columns, inputs.size());
  if (!writer.append(columns)) return false;
  h5::write_attribute(writer.datasets()[2], "units_by_kind", "px/s px 1 px px s 1 px/s");
  h5::write_attribute(writer.datasets()[3], "units_by_kind", "px/s px 1 px px 1 1 px/s");
  return writer.finish(columns, "frame");
}

}  // namespace

RowTable::RowTable(hid_t group, std::int64_t rows) : group_(group), rows_(rows) {
  const auto length = static_cast<hsize_t>(rows);
  step_ = h5::create_dataset(group, "step", H5T_STD_I64LE, {length});
  for (std::size_t column = 0; column < kRowColumns.size(); ++column)
    columns_[column] = h5::create_dataset(group, kRowColumns[column].name, H5T_IEEE_F64LE, {length});
  contact_ = h5::create_dataset(group, "contact", H5T_STD_U8LE, {length});
}

bool RowTable::append(const Columns& rows) {
  if (pending_.size() == 0 && rows.size() >= kBatch) return write(rows);
  append_to(pending_, rows);
  if (pending_.size() < kBatch) return true;
  const bool is_written = write(pending_);
  pending_.clear();
  return is_written;
}

bool RowTable::finish() {
  const bool is_written = pending_.size() == 0 || write(pending_);
  return describe(group_) && is_written && written_ == rows_;
}

void RowTable::close() {
  step_ = {};
  contact_ = {};
  columns_ = {};
}

bool RowTable::write(const Columns& rows) {
  const auto first = static_cast<hsize_t>(written_);
  const hsize_t count = rows.size();
  bool is_written = h5::write_rows(step_, H5T_NATIVE_INT64, first, count, rows.step.data()) >= 0;
  for (std::size_t column = 0; column < kRowColumns.size() && is_written; ++column)
    is_written = h5::write_rows(columns_[column], H5T_NATIVE_DOUBLE, first, count,
                                (rows.*kRowColumns[column].also).data()) >= 0;
  is_written =
      is_written && h5::write_rows(contact_, H5T_NATIVE_UINT8, first, count, rows.contact.data()) >= 0;
  written_ += static_cast<std::int64_t>(count);
  return is_written;
}

// Units, names and the time axis, as xarray (dimension scales) and silx (NXdata) expect them.
bool RowTable::describe(hid_t group) const {
  for (std::size_t column = 0; column < kRowColumns.size(); ++column) {
    h5::write_attribute(columns_[column], "units", kRowColumns[column].unit);
    h5::write_attribute(columns_[column], "long_name", kRowColumns[column].long_name);
  }
  h5::write_attribute(step_, "long_name", "row number");
  h5::write_attribute(
      contact_, "long_name",
      "clamps in the step that made the row: 1 left, 2 right, 4 top, 8 ground, 16 put to rest");
  h5::write_flags(contact_, "flag_masks", kContactFlags, kContactFlagNames);
  h5::write_attribute(group, "NX_class", "NXdata");
  h5::write_attribute(group, "signal", "y");
  h5::write_attribute(group, "axes", "t");
  return h5::share_axis(group, "t");
}

bool ContactTable::append(const Contact& contact) {
  batch_.push_back(contact);
  return batch_.size() < kBatch || flush();
}

bool ContactTable::set_last_step(std::int64_t index, std::int64_t last_step) {
  assert(index >= 0 && index < flushed_ + static_cast<std::int64_t>(batch_.size()));
  if (index >= flushed_) {
    batch_[static_cast<std::size_t>(index - flushed_)].last_step = last_step;
    return true;
  }
  return writer_->set(1, static_cast<hsize_t>(index), last_step);
}

bool ContactTable::finish() {
  const std::vector<Column> columns = columns_of(kContactColumns, batch_);
  if (!writer_) writer_.emplace(group_, columns, batch_.size());
  return writer_->append(columns) && writer_->finish(columns, "step");
}

bool ContactTable::flush() {
  const std::vector<Column> columns = columns_of(kContactColumns, batch_);
  if (!writer_) writer_.emplace(group_, columns, 0, kBatch);
  flushed_ += static_cast<std::int64_t>(batch_.size());
  batch_.clear();
  return writer_->append(columns);
}

bool write_head(hid_t file, const FileHead& head, const std::vector<Input>& inputs) {
  h5::write_attribute(file, "format", kTrajectoryFormat);
  h5::write_attribute(file, "name", head.scenario.name);
  h5::write_attribute(file, "scenario", to_text(to_json(head.scenario)));
  h5::write_attribute(file, "steps", head.steps);
  h5::write_attribute(file, "physics", head.physics);
  h5::write_attribute(file, "state_hash", head.state_hash);
  if (head.constants) h5::write_attribute(file, "constants", numbers_of(*head.constants));
  h5::write_attribute(file, "NX_class", "NXroot");
  h5::write_attribute(file, "default", "trajectory");
  write_provenance(file, own_provenance());
  std::vector<InputRecord> records;
  for (const Input& input : inputs) records.push_back(record_of(input));
  return write_inputs(file, records);
}

}  // namespace hyrax

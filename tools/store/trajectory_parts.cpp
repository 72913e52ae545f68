#include "tools/store/trajectory_parts.h"

#include <cassert>
#include <functional>

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
  for (const RowColumn& column : kRowColumns) append_to(rows.*column.values, more.*column.values);
}

h5::Handle make_dataset(hid_t group, const char* name, hid_t type, std::size_t length, bool is_growing) {
  if (is_growing) return h5::create_growing_dataset(group, name, type, ContactTable::kBatch);
  return h5::create_dataset(group, name, type, {length});
}

// One quantity of every contact of a batch.
template <class Value, class Get>
std::vector<Value> gather(const std::vector<Contact>& batch, const Get& get) {
  std::vector<Value> values;
  values.reserve(batch.size());
  for (const Contact& contact : batch) values.push_back(get(contact));
  return values;
}

template <class Value, class Get>
bool write_column(const h5::Handle& dataset, hid_t memory_type, const std::vector<InputRecord>& inputs,
                  const Get& get) {
  std::vector<Value> values;
  for (const InputRecord& input : inputs) values.push_back(get(input));
  return dataset.is_open() && (values.empty() || H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                          values.data()) >= 0);
}

// The meaning and unit of a and b depend on the kind.
void describe_numbers(hid_t kind, hid_t a, hid_t b) {
  h5::write_enum_flags(kind, input_kind_names());
  h5::write_attribute(kind, "long_name", "kind of the input");
  h5::write_attribute(
      a, "long_name",
      "vx of a fling or release, x of a place, width of a resize, dt of a hitch, or 0 (unused)");
  h5::write_attribute(b, "long_name",
                      "vy of a fling or release, y of a place, height of a resize, or 0 (unused)");
  h5::write_attribute(a, "units_by_kind", "px/s px 1 px px s 1 px/s");
  h5::write_attribute(b, "units_by_kind", "px/s px 1 px px 1 1 px/s");
}

bool write_inputs(hid_t file, const std::vector<InputRecord>& inputs) {
  const h5::Handle group = h5::create_group(file, "events");
  const h5::Handle kind_type = h5::enum_type(input_kind_names());
  const auto make = [&](const char* name, hid_t type) {
    return h5::create_dataset(group, name, type, {inputs.size()});
  };
  const h5::Handle frame = make("frame", H5T_STD_I64LE);
  const h5::Handle kind = make("kind", kind_type);
  const h5::Handle a = make("a", H5T_IEEE_F64LE);
  const h5::Handle b = make("b", H5T_IEEE_F64LE);
  const bool is_written =
      write_column<std::int64_t>(frame, H5T_NATIVE_INT64, inputs, std::mem_fn(&InputRecord::frame)) &&
      write_column<std::uint8_t>(kind, kind_type, inputs, std::mem_fn(&InputRecord::kind)) &&
      write_column<double>(a, H5T_NATIVE_DOUBLE, inputs, std::mem_fn(&InputRecord::a)) &&
      write_column<double>(b, H5T_NATIVE_DOUBLE, inputs, std::mem_fn(&InputRecord::b));
  h5::write_attribute(frame, "long_name", "frame to which the input was applied; it makes row frame + 1");
  describe_numbers(kind, a, b);
  return is_written && h5::share_axis(group, "frame");
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
  bool is_written = h5::write_part(step_, H5T_NATIVE_INT64, first, count, rows.step.data()) >= 0;
  for (std::size_t column = 0; column < kRowColumns.size() && is_written; ++column)
    is_written = h5::write_part(columns_[column], H5T_NATIVE_DOUBLE, first, count,
                                (rows.*kRowColumns[column].values).data()) >= 0;
  is_written =
      is_written && h5::write_part(contact_, H5T_NATIVE_UINT8, first, count, rows.contact.data()) >= 0;
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
  return h5::write_part(datasets_[1], H5T_NATIVE_INT64, static_cast<hsize_t>(index), 1, &last_step) >= 0;
}

bool ContactTable::finish() {
  if (datasets_.empty() && !make_datasets(false)) return false;
  const bool is_written = batch_.empty() || flush();
  return describe() && is_written;
}

bool ContactTable::make_datasets(bool is_growing) {
  const std::size_t length = batch_.size();
  datasets_.push_back(make_dataset(group_, "step", H5T_STD_I64LE, length, is_growing));
  datasets_.push_back(make_dataset(group_, "last_step", H5T_STD_I64LE, length, is_growing));
  datasets_.push_back(make_dataset(group_, "wall", H5T_STD_U8LE, length, is_growing));
  for (const ContactColumn& column : kContactColumns)
    datasets_.push_back(make_dataset(group_, column.name, H5T_IEEE_F64LE, length, is_growing));
  for (const h5::Handle& dataset : datasets_)
    if (!dataset.is_open()) return false;
  return true;
}

bool ContactTable::flush() {
  if (datasets_.empty() && !make_datasets(true)) return false;
  const auto first = static_cast<hsize_t>(flushed_);
  const hsize_t count = batch_.size();
  bool is_written = true;
  const auto write = [&](std::size_t dataset, hid_t type, const void* data) {
    is_written = h5::write_part(datasets_[dataset], type, first, count, data) >= 0 && is_written;
  };
  const auto steps = [&](auto member) {
    return gather<std::int64_t>(batch_, [member](const Contact& contact) { return contact.*member; });
  };
  write(0, H5T_NATIVE_INT64, steps(&Contact::step).data());
  write(1, H5T_NATIVE_INT64, steps(&Contact::last_step).data());
  const auto walls = gather<std::uint8_t>(
      batch_, [](const Contact& contact) { return static_cast<std::uint8_t>(contact.wall); });
  write(2, H5T_NATIVE_UINT8, walls.data());
  for (std::size_t column = 0; column < kContactColumns.size(); ++column) {
    const auto member = kContactColumns[column].value;
    const auto values = gather<double>(batch_, [member](const Contact& contact) { return contact.*member; });
    write(3 + column, H5T_NATIVE_DOUBLE, values.data());
  }
  flushed_ += static_cast<std::int64_t>(batch_.size());
  batch_.clear();
  return is_written;
}

bool ContactTable::describe() const {
  h5::write_attribute(datasets_[0], "long_name", "first clamped row");
  h5::write_attribute(datasets_[1], "long_name", "last clamped row");
  h5::write_attribute(datasets_[2], "long_name", "wall: 1 left, 2 right, 4 top, 8 ground");
  for (std::size_t column = 0; column < kContactColumns.size(); ++column) {
    h5::write_attribute(datasets_[3 + column], "units", kContactColumns[column].unit);
    h5::write_attribute(datasets_[3 + column], "long_name", kContactColumns[column].long_name);
  }
  h5::write_flags(datasets_[2], "flag_values", std::span(kContactFlags).first(kWalls.size()),
                  std::span(kContactFlagNames).first(kWalls.size()));
  return h5::share_axis(group_, "step");
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

#include "tools/store/row_table.h"

#include "tools/store/trajectory_format.h"

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

}  // namespace

RowTable::RowTable(hid_t group, std::int64_t rows) : group_(group), rows_(rows) {
  const auto length = static_cast<hsize_t>(rows);
  step_ = h5::create_dataset(group, "step", H5T_STD_I64LE, {length});
  for (std::size_t column = 0; column < kRowColumns.size(); ++column)
    columns_[column] = h5::create_dataset(group, kRowColumns[column].name, H5T_IEEE_F64LE, {length});
  contact_ = h5::create_dataset(group, "contact", H5T_STD_U8LE, {length});
}

bool RowTable::append(const Columns& rows) {
  if (gathered_.size() == 0 && rows.size() >= kBatch) return write(rows);
  append_to(gathered_, rows);
  if (gathered_.size() < kBatch) return true;
  const bool is_written = write(gathered_);
  gathered_.clear();
  return is_written;
}

bool RowTable::finish() {
  const bool is_written = gathered_.size() == 0 || write(gathered_);
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

// Units, names and the time axis, as xarray (dimension scales) and silx (NXdata) look for them.
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

}  // namespace hyrax

#include "tools/store/drift_row_table.h"

#include <hdf5_hl.h>

#include <limits>

#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

constexpr std::size_t kBatch = 65536;

const DriftColumn<RowErrors>& column_of(std::size_t index) {
  return index < kReferenceRowColumns.size() ? kReferenceRowColumns[index]
                                             : kDriftRowColumns[index - kReferenceRowColumns.size()];
}

// As xarray (dimension scales) and silx (NXdata) look for the time axis.
bool describe(hid_t file, hid_t group, const char* signal) {
  h5::write_attribute(group, "NX_class", "NXdata");
  h5::write_attribute(group, "signal", signal);
  h5::write_attribute(group, "axes", "t");
  return H5Lcreate_hard(file, "/trajectory/t", group, "t", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
         H5Lcreate_hard(file, "/trajectory/step", group, "step", H5P_DEFAULT, H5P_DEFAULT) >= 0;
}

}  // namespace

DriftRowTable::DriftRowTable(hid_t reference, hid_t drift, std::int64_t steps, std::int64_t rows_every)
    : reference_(reference),
      drift_(drift),
      steps_(steps),
      rows_every_(rows_every),
      rows_(TrajectoryWriter::row_count(steps, rows_every)) {
  for (std::size_t index = 0; index < kColumns; ++index)
    datasets_[index] =
        h5::create_dataset(index < kReferenceRowColumns.size() ? reference : drift, column_of(index).name,
                           H5T_IEEE_F64LE, {static_cast<hsize_t>(rows_)});
}

void DriftRowTable::row(const RowErrors& row) {
  const bool is_due = row.step % rows_every_ == 0;
  if (!is_due && row.step != steps_) return;
  const std::int64_t index = is_due ? row.step / rows_every_ : rows_ - 1;
  if (index < next_) return;  // It ended an arc, and now begins the next.
  put_nothing_up_to(index);
  Values values;
  for (std::size_t column = 0; column < kColumns; ++column) values[column] = column_of(column).get(row);
  put(values);
}

bool DriftRowTable::finish(hid_t file) {
  put_nothing_up_to(rows_);
  flush();
  const h5::Handle time(H5Dopen2(file, "/trajectory/t", H5P_DEFAULT), H5Dclose);
  for (std::size_t column = 0; column < kColumns; ++column) {
    h5::write_attribute(datasets_[column], "units", column_of(column).unit);
    h5::write_attribute(datasets_[column], "long_name", column_of(column).long_name);
    is_written_ = H5DSattach_scale(datasets_[column], time, 0) >= 0 && is_written_;
    datasets_[column] = {};
  }
  return describe(file, reference_, "y") && describe(file, drift_, "truncation") && is_written_;
}

void DriftRowTable::put(const Values& values) {
  for (std::size_t column = 0; column < kColumns; ++column) gathered_[column].push_back(values[column]);
  ++next_;
  if (gathered_.front().size() == kBatch) flush();
}

void DriftRowTable::put_nothing_up_to(std::int64_t index) {
  Values nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  while (next_ < index) put(nothing);
}

void DriftRowTable::flush() {
  const hsize_t count = gathered_.front().size();
  if (count == 0) return;
  for (std::size_t column = 0; column < kColumns; ++column) {
    is_written_ = h5::write_part(datasets_[column], H5T_NATIVE_DOUBLE, static_cast<hsize_t>(flushed_), count,
                                 gathered_[column].data()) >= 0 &&
                  is_written_;
    gathered_[column].clear();
  }
  flushed_ += static_cast<std::int64_t>(count);
}

}  // namespace hyrax

#include "tools/store/contact_table.h"

#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

h5::Handle make(hid_t group, const char* name, hid_t type, std::size_t length, bool is_growing) {
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

}  // namespace

bool ContactTable::append(const Contact& contact) {
  batch_.push_back(contact);
  return batch_.size() < kBatch || flush();
}

bool ContactTable::set_last_step(std::int64_t index, std::int64_t last_step) {
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
  datasets_.push_back(make(group_, "step", H5T_STD_I64LE, length, is_growing));
  datasets_.push_back(make(group_, "last_step", H5T_STD_I64LE, length, is_growing));
  datasets_.push_back(make(group_, "wall", H5T_STD_U8LE, length, is_growing));
  for (const ContactColumn& column : kContactColumns)
    datasets_.push_back(make(group_, column.name, H5T_IEEE_F64LE, length, is_growing));
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
  const auto whole = [&](auto member) {
    return gather<std::int64_t>(batch_, [member](const Contact& contact) { return contact.*member; });
  };
  write(0, H5T_NATIVE_INT64, whole(&Contact::step).data());
  write(1, H5T_NATIVE_INT64, whole(&Contact::last_step).data());
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

}  // namespace hyrax

#include "tools/store/hdf5.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>

namespace hyrax::h5 {
namespace {

// Must be called before any other function. At the end of the process HDF5 1.10 would try again to write what
// it could not write before, and can crash; all files are closed by then.
void initialize() {
  static const herr_t result = H5dont_atexit();
  static_cast<void>(result);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle object_list(hid_t list_class) {
  Handle list(H5Pcreate(list_class), H5Pclose);
  H5Pset_obj_track_times(list, false);
  return list;
}

constexpr std::size_t kGrowth = 64 << 10;  // Of a file in memory, in bytes.

// A small file is kept in memory, and read or written at once instead of with some seventy system calls.
Handle access_list(std::uint64_t bytes) {
  constexpr std::uint64_t kSmall = 4 << 20;
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (bytes <= kSmall) H5Pset_fapl_core(access, kGrowth, true);
  return access;
}

Handle create(const std::string& path, const Handle& access) {
  const Handle creation = object_list(H5P_FILE_CREATE);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Pset_file_locking(access, false, true);  // No other process knows it until it is complete.
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose};
}

Handle dataset_list() {
  Handle list = object_list(H5P_DATASET_CREATE);
  H5Pset_fill_time(list, H5D_FILL_TIME_NEVER);
  return list;
}

Handle create_with(hid_t creation, hid_t parent, const char* name, hid_t type,
                   const std::vector<hsize_t>& extent, const hsize_t* extent_max = nullptr) {
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), extent_max), H5Sclose);
  return {H5Dcreate2(parent, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose};
}

// A dataset that grows, stored in chunks of `chunk` elements.
Handle create_growing_dataset(hid_t parent, const char* name, hid_t type, hsize_t chunk) {
  const hsize_t unlimited = H5S_UNLIMITED;
  const Handle creation = dataset_list();
  H5Pset_chunk(creation, 1, &chunk);
  return create_with(creation, parent, name, type, {0}, &unlimited);
}

// Variable-length UTF-8 text.
Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

}  // namespace

Handle create_file(const std::string& path, std::uint64_t expected_bytes) {
  initialize();
  return create(path, access_list(expected_bytes));
}

Handle create_file_in_memory() {
  initialize();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, kGrowth, false);
  return create("/dev/null/in-memory",
                access);  // The library looks for a file of this name, which must not exist.
}

Handle open_file(const std::string& path) {
  initialize();
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  const Handle access = access_list(error ? 0 : bytes);
  H5Pset_file_locking(access, true, true);  // Some network file systems have no locks.
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose};
}

hid_t file_type(ValueType type) {
  const hid_t types[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I8LE, H5T_STD_I16LE,
                         H5T_STD_I32LE,  H5T_STD_I64LE,  H5T_STD_U8LE, H5T_STD_U16LE,
                         H5T_STD_U32LE,  H5T_STD_U64LE,  H5T_STD_U8LE};
  return types[static_cast<std::size_t>(type)];
}

Handle enum_type(ValueType number, std::span<const std::string> names) {
  return visit_stored(number, [&](auto code) {
    Handle type(H5Tenum_create(native_type<decltype(code)>()), H5Tclose);
    for (const std::string& name : names) H5Tenum_insert(type, name.c_str(), &code), ++code;
    return type;
  });
}

Handle create_group(hid_t parent, const char* name) {
  return {H5Gcreate2(parent, name, H5P_DEFAULT, object_list(H5P_GROUP_CREATE), H5P_DEFAULT), H5Gclose};
}

Handle create_dataset(hid_t parent, const char* name, hid_t type, const std::vector<hsize_t>& extent) {
  return create_with(dataset_list(), parent, name, type, extent);
}

namespace {

std::vector<hsize_t> extent_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int dimensions = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extent(static_cast<std::size_t>(std::max(dimensions, 0)));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}

// What transfer(memory space, file space) returns for rows of a dataset; negative if it has no such rows.
herr_t transfer_rows(hid_t dataset, hsize_t first, hsize_t count, const auto& transfer) {
  std::vector<hsize_t> size = extent_of(dataset);
  if (size.empty() || first + count > size.front()) return -1;
  std::vector<hsize_t> start(size.size(), 0);
  start.front() = first;
  size.front() = count;
  const Handle memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  const Handle file(H5Dget_space(dataset), H5Sclose);
  if (H5Sselect_hyperslab(file, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) < 0) return -1;
  return transfer(memory, file);
}

// An attribute of a list of `count` elements, or of one value.
void write_attribute_of(hid_t object, const char* name, hid_t type, hid_t memory_type, const void* data,
                        std::optional<hsize_t> count = {}) {
  const Handle space(count ? H5Screate_simple(1, &*count, nullptr) : H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  H5Awrite(attribute, memory_type, data);
}

}  // namespace

herr_t write_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, const void* data) {
  if (std::vector<hsize_t> size = extent_of(dataset); !size.empty() && first + count > size.front()) {
    size.front() = first + count;
    if (H5Dset_extent(dataset, size.data()) < 0) return -1;
  }
  return transfer_rows(dataset, first, count, [&](hid_t memory, hid_t file) {
    return H5Dwrite(dataset, memory_type, memory, file, H5P_DEFAULT, data);
  });
}

herr_t read_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, void* data) {
  return transfer_rows(dataset, first, count, [&](hid_t memory, hid_t file) {
    return H5Dread(dataset, memory_type, memory, file, H5P_DEFAULT, data);
  });
}

bool share_axis(hid_t group, const char* scale) {
  struct Axis {
    const char* name;
    Handle scale;
  } axis{scale, {H5Dopen2(group, scale, H5P_DEFAULT), H5Dclose}};
  const auto attach = [](hid_t parent, const char* name, const H5L_info_t*, void* to) -> herr_t {
    const auto& [scale_name, scale_dataset] = *static_cast<const Axis*>(to);
    const Handle object(H5Oopen(parent, name, H5P_DEFAULT), H5Oclose);
    if (std::string_view(name) == scale_name || H5Iget_type(object) != H5I_DATASET) return 0;
    return extent_of(object) == extent_of(scale_dataset) ? H5DSattach_scale(object, scale_dataset, 0)
                                                         : H5DSset_scale(object, name);
  };
  return H5DSset_scale(axis.scale, scale) >= 0 &&
         H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, attach, &axis) >= 0;
}

void write_flags(hid_t dataset, const char* codes, std::span<const std::uint8_t> values,
                 std::span<const std::string_view> meanings) {
  assert(values.size() == meanings.size());
  write_attribute_of(dataset, codes, H5T_STD_U8LE, H5T_NATIVE_UINT8, values.data(), values.size());
  std::string text;
  for (const std::string_view meaning : meanings) text.append(text.empty() ? "" : " ").append(meaning);
  write_attribute(dataset, "flag_meanings", text);
}

void write_attribute(hid_t object, const char* name, std::string_view text) {
  const std::string terminated(text);
  const char* const data = terminated.c_str();
  const Handle type = text_type();
  write_attribute_of(object, name, type, type, static_cast<const void*>(&data));
}

void write_attribute(hid_t object, const char* name, std::int64_t value) {
  write_attribute_of(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

void write_attribute(hid_t object, const char* name, std::span<const double> values) {
  write_attribute_of(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data(), values.size());
}

bool has_attribute(hid_t object, const char* name) { return H5Aexists(object, name) > 0; }

namespace {

// An attribute; not open if it is missing.
struct StoredAttribute {
  StoredAttribute(hid_t object, const char* name) : attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose) {
    if (!attribute.is_open()) return;
    type = Handle(H5Aget_type(attribute), H5Tclose);
    space = Handle(H5Aget_space(attribute), H5Sclose);
    count = H5Sget_simple_extent_npoints(space);
  }
  Handle attribute, type, space;
  hssize_t count = -1;
};

}  // namespace

std::optional<std::string> read_text_attribute(hid_t object, const char* name) {
  const StoredAttribute stored(object, name);
  if (stored.count != 1 || H5Tis_variable_str(stored.type) <= 0) return std::nullopt;
  char* data = nullptr;
  const Handle type = text_type();
  if (H5Aread(stored.attribute, type, static_cast<void*>(&data)) < 0 || data == nullptr) return std::nullopt;
  std::string text(data);
  H5free_memory(data);
  return text;
}

std::optional<std::int64_t> read_integer_attribute(hid_t object, const char* name) {
  const StoredAttribute stored(object, name);
  std::int64_t value = 0;
  if (stored.count != 1 || H5Tget_class(stored.type) != H5T_INTEGER ||
      H5Aread(stored.attribute, H5T_NATIVE_INT64, &value) < 0)
    return std::nullopt;
  return value;
}

std::optional<std::vector<double>> read_numbers_attribute(hid_t object, const char* name, std::size_t count) {
  const StoredAttribute stored(object, name);
  if (stored.count != static_cast<hssize_t>(count) || H5Tget_class(stored.type) != H5T_FLOAT ||
      H5Tget_size(stored.type) != sizeof(double) || H5Sget_simple_extent_ndims(stored.space) != 1)
    return std::nullopt;
  std::vector<double> values(count);
  if (H5Aread(stored.attribute, H5T_NATIVE_DOUBLE, values.data()) < 0) return std::nullopt;
  return values;
}

namespace {

// A column's values as they are written.
struct ColumnData {
  hid_t type;
  hid_t memory_type;
  const void* data;
  hsize_t count;
  Handle owned_type = {};
  std::vector<std::int64_t> integers = {};
  std::string padded = {};
};

ColumnData data_of(const std::vector<double>& values) {
  return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data(), values.size()};
}
ColumnData data_of(const std::vector<std::int64_t>& values) {
  return {H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), values.size()};
}
ColumnData data_of(const std::vector<std::uint64_t>& values) {
  return {H5T_STD_U64LE, H5T_NATIVE_UINT64, values.data(), values.size()};
}
// Of bools and of integers that may be missing.
ColumnData data_of(const auto& values, const auto& integer_of) {
  std::vector<std::int64_t> integers;
  for (const auto& value : values) integers.push_back(integer_of(value));
  ColumnData column = data_of(integers);
  column.integers = std::move(integers);
  return column;
}
ColumnData data_of(const std::vector<bool>& values) {
  return data_of(values, [](bool value) { return std::int64_t{value}; });
}
ColumnData data_of(const std::vector<std::optional<std::int64_t>>& values) {
  return data_of(values, [](const std::optional<std::int64_t>& value) { return value.value_or(-1); });
}

ColumnData data_of(const Codes& values) {
  ColumnData column{H5T_STD_U8LE, H5T_NATIVE_UINT8, values.codes.data(), values.size()};
  if (values.names.are_bits || values.names.names.empty()) return column;
  column.owned_type = enum_type(
      ValueType::uint8, std::vector<std::string>(values.names.names.begin(), values.names.names.end()));
  column.type = column.memory_type = column.owned_type;
  return column;
}

// Text of variable length would lie in a heap apart, with gaps that nobody fills.
ColumnData data_of(const std::vector<std::string>& values) {
  std::size_t width = 1;
  for (const std::string& value : values) width = std::max(width, value.size());
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, width);
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  ColumnData column{type, type, nullptr, values.size(), std::move(type)};
  for (const std::string& value : values) column.padded += value + std::string(width - value.size(), '\0');
  return column;
}

ColumnData data_of(const std::vector<Table>&) {
  assert(false);  // Tables in cells are for JSON.
  return {};
}

ColumnData as_in_memory(const Column& column) {
  return std::visit([](const auto& values) { return data_of(values); }, column.values);
}

ColumnData data_of(const Column& column) {
  if (!column.stored_as) return as_in_memory(column);
  ColumnData data{};
  with_numbers(column, [&](const auto& values) {
    data.count = values.size();
    visit_stored(*column.stored_as, [&]<class Stored>(Stored) {
      data.type = file_type(*column.stored_as);
      data.memory_type = native_type<Stored>();
      for (const auto value : values) {
        const auto stored = static_cast<Stored>(value);
        data.padded.append(reinterpret_cast<const char*>(&stored), sizeof stored);
      }
    });
  });
  if (column.value_names.empty()) return data;
  data.owned_type = enum_type(*column.stored_as, column.value_names);
  data.type = data.memory_type = data.owned_type;
  return data;
}

std::vector<hsize_t> extent_of(const Column& column, hsize_t rows) {
  return column.width == 1 ? std::vector{rows} : std::vector<hsize_t>{rows, column.width};
}

}  // namespace

herr_t read_rows(hid_t dataset, hsize_t first, hsize_t count, Column& column) {
  const ColumnData data = as_in_memory(column);
  herr_t result = -1;
  with_numbers(column, [&](auto& values) {
    values.resize(count * column.width);
    result = count == 0 ? 0 : read_rows(dataset, data.memory_type, first, count, values.data());
  });
  return result;
}

std::vector<Handle> create_columns(hid_t group, const std::vector<Column>& columns, hsize_t rows) {
  const Handle creation = dataset_list();
  H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
  std::vector<Handle> datasets;
  for (const Column& column : columns)
    datasets.push_back(
        create_with(creation, group, column.name.c_str(), data_of(column).type, extent_of(column, rows)));
  return datasets;
}

std::vector<Handle> open_columns(hid_t group, const std::vector<Column>& columns, hsize_t rows) {
  std::vector<Handle> datasets;
  for (const Column& column : columns) {
    datasets.emplace_back(H5Dopen2(group, column.name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!datasets.back().is_open() || extent_of(datasets.back()) != extent_of(column, rows)) return {};
  }
  return datasets;
}

ColumnWriter::ColumnWriter(hid_t group, const std::vector<Column>& columns, hsize_t rows, hsize_t chunk)
    : group_(group) {
  for (const Column& column : columns) {
    assert(column.width == 1);
    const ColumnData data = data_of(column);
    const char* const name = column.name.c_str();
    datasets_.push_back(chunk > 0 ? create_growing_dataset(group, name, data.type, chunk)
                                  : create_dataset(group, name, data.type, {rows}));
    is_written_ = is_written_ && datasets_.back().is_open();
  }
}

bool ColumnWriter::append(const std::vector<Column>& columns) {
  hsize_t count = 0;
  for (std::size_t index = 0; index < columns.size() && is_written_; ++index) {
    const ColumnData data = data_of(columns[index]);
    count = data.count / columns[index].width;
    const void* const values = data.padded.empty() ? data.data : data.padded.data();
    if (count > 0) is_written_ = write_rows(datasets_[index], data.memory_type, written_, count, values) >= 0;
  }
  written_ += count;
  return is_written_;
}

bool ColumnWriter::set(std::size_t column, hsize_t row, std::int64_t value) {
  return write_rows(datasets_[column], H5T_NATIVE_INT64, row, 1, &value) >= 0;
}

bool ColumnWriter::finish(const std::vector<Column>& columns, const char* axis) {
  if (!is_written_) return false;
  for (std::size_t index = 0; index < columns.size(); ++index) {
    if (!columns[index].unit.empty()) write_attribute(datasets_[index], "units", columns[index].unit);
    write_attribute(datasets_[index], "long_name", columns[index].long_name);
  }
  for (std::size_t index = 0; index < columns.size(); ++index) {
    const auto* const named = std::get_if<Codes>(&columns[index].values);
    if (named == nullptr || named->names.names.empty()) continue;
    const auto& [names, are_bits] = named->names;
    std::vector<std::uint8_t> codes(names.size());
    for (std::size_t code = 0; code < codes.size(); ++code)
      codes[code] = static_cast<std::uint8_t>(are_bits ? 1u << code : code);
    write_flags(datasets_[index], "flag_values", codes, names);
  }
  return axis == nullptr || share_axis(group_, axis);
}

bool write_columns(hid_t group, const std::vector<Column>& columns, const char* axis) {
  ColumnWriter writer(group, columns, columns.empty() ? 0 : length(columns.front()));
  return writer.append(columns) && writer.finish(columns, axis);
}

}  // namespace hyrax::h5

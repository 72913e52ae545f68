// The part of the HDF5 C interface that this program uses, with handles that close themselves.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/result/table.h"

namespace hyrax::h5 {

/// Owns one identifier of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close_id) : id_(id), close_(close_id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { static_cast<void>(close()); }
  operator hid_t() const { return id_; }  // An argument of every H5 call.
  [[nodiscard]] bool is_open() const { return id_ >= 0; }
  /// Closes now. Returns a negative value if buffered data could not be written.
  [[nodiscard]] herr_t close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 ? 0 : close_(id);
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// A new file of a fixed, old format and without time stamps, so that equal content gives equal
/// bytes and any reader since HDF5 1.8 opens it.
/// @param expected_bytes decides whether it is kept in memory until it is closed, or written as it grows.
[[nodiscard]] Handle create_file(const std::string& path, std::uint64_t expected_bytes);
/// The same in memory only; nothing is written to a disk.
[[nodiscard]] Handle create_file_in_memory();
/// Opens an existing file for reading; not open if it is not an HDF5 file. In the thread that created or
/// opened a file with these functions the library prints no errors.
[[nodiscard]] Handle open_file(const std::string& path);

[[nodiscard]] Handle create_group(hid_t parent, const char* name);

/// A dataset of fixed length, stored contiguously.
[[nodiscard]] Handle create_dataset(hid_t parent, const char* name, hid_t type,
                                    const std::vector<hsize_t>& extent);
/// Writes rows `first` .. `first + count - 1` of a dataset of one or two dimensions, and extends one that
/// grows if needed. Returns a negative value on failure.
[[nodiscard]] herr_t write_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count,
                                const void* data);
/// Reads them. Returns a negative value on failure.
[[nodiscard]] herr_t read_rows(hid_t dataset, hid_t memory_type, hsize_t first, hsize_t count, void* data);
/// Reads rows as values of the type that the column has: numbers, or codes. Returns a negative value on
/// failure.
[[nodiscard]] herr_t read_rows(hid_t dataset, hsize_t first, hsize_t count, Column& column);

/// Makes dataset `scale` of a group the axis (dimension scale) of the group's other datasets; those of
/// another length become axes themselves. netCDF readers such as xarray need this to open the group.
/// REQUIRES: all datasets of the group have one dimension.
/// Returns false if the file could not be written.
[[nodiscard]] bool share_axis(hid_t group, const char* scale);

/// Names the codes in a dataset of bytes, by the CF conventions.
/// @param codes "flag_values" if an element is one of them, "flag_masks" if it is a sum of them.
/// @param meanings a name for each, without blanks. REQUIRES: as many as `values`.
void write_flags(hid_t dataset, const char* codes, std::span<const std::uint8_t> values,
                 std::span<const std::string_view> meanings);

/// The library's type of a number in memory.
template <class Number>
[[nodiscard]] hid_t native_type() {
  if constexpr (std::is_floating_point_v<Number>)
    return sizeof(Number) == sizeof(double) ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT;
  constexpr std::size_t kSize = sizeof(Number);
  if constexpr (std::is_signed_v<Number>)
    return kSize == 1   ? H5T_NATIVE_INT8
           : kSize == 2 ? H5T_NATIVE_INT16
           : kSize == 4 ? H5T_NATIVE_INT32
                        : H5T_NATIVE_INT64;
  return kSize == 1   ? H5T_NATIVE_UINT8
         : kSize == 2 ? H5T_NATIVE_UINT16
         : kSize == 4 ? H5T_NATIVE_UINT32
                      : H5T_NATIVE_UINT64;
}

/// That of a value in a file, and an enumeration over it: the names of 0, 1, 2, ...
[[nodiscard]] hid_t file_type(ValueType type);
[[nodiscard]] Handle enum_type(ValueType type, std::span<const std::string> names);

/// Creates a dataset for each column, with `rows` rows. Their space is allocated at once, so that writing
/// rows changes no other part of the file.
[[nodiscard]] std::vector<Handle> create_columns(hid_t group, const std::vector<Column>& columns,
                                                 hsize_t rows);
/// Opens the columns' datasets; empty if one is missing or has another extent.
[[nodiscard]] std::vector<Handle> open_columns(hid_t group, const std::vector<Column>& columns, hsize_t rows);

/// Datasets of a group, one for each column of a table whose chunks come one after another. Text is
/// fixed-length UTF-8, padded with zeros; a bool is 0 or 1; codes without names are bytes. REQUIRES: no
/// column of tables.
class ColumnWriter {
 public:
  /// @param columns names and types; their values are not written. REQUIRES: columns of width 1.
  /// @param chunk more than 0: the datasets grow, stored in chunks of as many rows; else they have `rows`.
  ColumnWriter(hid_t group, const std::vector<Column>& columns, hsize_t rows, hsize_t chunk = 0);
  /// Of create_columns. REQUIRES: it is finished without an axis.
  explicit ColumnWriter(std::vector<Handle> datasets) : datasets_(std::move(datasets)) {}

  /// Each returns false if the file could not be written.
  [[nodiscard]] bool append(const std::vector<Column>& columns);
  /// REQUIRES: the row was appended; the column is of integers.
  [[nodiscard]] bool set(std::size_t column, hsize_t row, std::int64_t value);
  /// Describes the datasets; `axis`, if not null, is the axis of the others.
  [[nodiscard]] bool finish(const std::vector<Column>& columns, const char* axis);
  void close() { datasets_.clear(); }
  [[nodiscard]] const std::vector<Handle>& datasets() const { return datasets_; }

 private:
  hid_t group_ = H5I_INVALID_HID;
  std::vector<Handle> datasets_;
  hsize_t written_ = 0;
  bool is_written_ = true;
};

/// All rows at once.
[[nodiscard]] bool write_columns(hid_t group, const std::vector<Column>& columns, const char* axis);

void write_attribute(hid_t object, const char* name, std::string_view text);
void write_attribute(hid_t object, const char* name, std::int64_t value);
void write_attribute(hid_t object, const char* name, std::span<const double> values);

[[nodiscard]] bool has_attribute(hid_t object, const char* name);
/// Nothing if the attribute is missing or of another type.
[[nodiscard]] std::optional<std::string> read_text_attribute(hid_t object, const char* name);
[[nodiscard]] std::optional<std::int64_t> read_integer_attribute(hid_t object, const char* name);
/// A list of `count` float64, at least one.
[[nodiscard]] std::optional<std::vector<double>> read_numbers_attribute(hid_t object, const char* name,
                                                                        std::size_t count);

}  // namespace hyrax::h5

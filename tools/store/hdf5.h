// The HDF5 C interface as far as this program uses it: handles that close themselves, and failures
// that say what the library said.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax::h5 {

/// Owns one identifier of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close_id) : id_(id), close_(close_id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this == &other) return *this;
    static_cast<void>(close());
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
    return *this;
  }
  ~Handle() { static_cast<void>(close()); }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): goes into every H5 call.
  [[nodiscard]] bool is_open() const { return id_ >= 0; }
  /// Closes now; a failure to write what was held back shows here.
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
/// @param expected_bytes decides whether it is gathered in memory or written as it grows.
[[nodiscard]] Handle create_file(const std::string& path, std::uint64_t expected_bytes);
/// The same in memory alone: nothing is written anywhere.
[[nodiscard]] Handle create_file_in_memory();
/// An existing file, to be read; not open where it is no HDF5 file. The library prints no errors of
/// its own in the thread that made or opened a file so.
[[nodiscard]] Handle open_file(const std::string& path);

[[nodiscard]] Handle create_group(hid_t parent, const char* name);

/// A dataset whose length is known: stored in one piece.
[[nodiscard]] Handle create_dataset(hid_t parent, const char* name, hid_t type, std::vector<hsize_t> shape);
/// A dataset that grows, stored in chunks of `chunk` elements.
[[nodiscard]] Handle create_growing_dataset(hid_t parent, const char* name, hid_t type, hsize_t chunk);
/// Elements `first` .. `first + count - 1` along the first axis, which is made longer if need be.
/// Returns the library's verdict.
[[nodiscard]] herr_t write_part(const Handle& dataset, hid_t memory_type, hsize_t first, hsize_t count,
                                const void* data);

/// Makes dataset `scale` of a group the axis (dimension scale) of the group's other datasets, and those of
/// another length axes of their own, which is what netCDF readers such as xarray need to open the group.
/// REQUIRES: all datasets of the group have one dimension.
/// Returns false where the file could not be written.
[[nodiscard]] bool share_axis(hid_t group, const char* scale);

/// Names the codes in a dataset of bytes, as the CF conventions have it.
/// @param codes "flag_values", of which an element is one, or "flag_masks", of which it is a sum.
/// @param meanings a name for each, without blanks.
void write_flags(hid_t dataset, const char* codes, std::span<const std::uint8_t> values,
                 std::span<const std::string_view> meanings);

/// An enumeration of bytes: the names stand for 0, 1, 2, ...
[[nodiscard]] Handle enum_type(std::span<const std::string_view> names);
/// Names the codes in a dataset of that type for readers that do not know enumerations.
void write_enum_flags(hid_t dataset, std::span<const std::string_view> names);

void write_attribute(hid_t object, const char* name, std::string_view text);
void write_attribute(hid_t object, const char* name, std::int64_t value);

/// Nothing where the attribute is missing or of another type.
[[nodiscard]] std::optional<std::string> read_text_attribute(hid_t object, const char* name);
[[nodiscard]] std::optional<std::int64_t> read_integer_attribute(hid_t object, const char* name);

/// Variable-length UTF-8 text.
[[nodiscard]] Handle text_type();

}  // namespace hyrax::h5

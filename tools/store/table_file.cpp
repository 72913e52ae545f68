#include "tools/store/table_file.h"

#include <algorithm>
#include <cassert>
#include <cerrno>

#include "tools/files/atomic_file.h"
#include "tools/store/hdf5.h"
#include "tools/store/provenance.h"

namespace hyrax {
namespace {

constexpr std::string_view kStudyFormat = "hyrax-study/1";

bool write_values(hid_t group, const Column& column, hid_t type, hid_t memory_type, std::size_t count,
                  const void* data) {
  const h5::Handle dataset = h5::create_dataset(group, column.name.c_str(), type, {count});
  if (!dataset.is_open()) return false;
  if (!column.unit.empty()) h5::write_attribute(dataset, "units", column.unit);
  h5::write_attribute(dataset, "long_name", column.long_name);
  return count == 0 || H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
}

bool write_column(hid_t group, const Column& column, const std::vector<double>& values) {
  return write_values(group, column, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

bool write_column(hid_t group, const Column& column, const std::vector<std::int64_t>& values) {
  return write_values(group, column, H5T_STD_I64LE, H5T_NATIVE_INT64, values.size(), values.data());
}

bool write_column(hid_t group, const Column& column, const std::vector<bool>& values) {
  return write_column(group, column, std::vector<std::int64_t>(values.begin(), values.end()));
}

bool write_column(hid_t, const Column&, const std::vector<Table>&) {
  assert(false);  // Tables in cells are for JSON.
  return false;
}

// Text of variable length would lie in a heap apart, with gaps that nobody fills.
bool write_column(hid_t group, const Column& column, const std::vector<std::string>& values) {
  std::size_t width = 1;
  for (const std::string& value : values) width = std::max(width, value.size());
  std::string padded;
  for (const std::string& value : values) padded += value + std::string(width - value.size(), '\0');
  const h5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, width);
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return write_values(group, column, type, type, values.size(), padded.data());
}

bool write_table(hid_t file, const Table& table) {
  const h5::Handle group = h5::create_group(file, table.name.c_str());
  if (!group.is_open()) return false;
  h5::write_attribute(group, "long_name", table.long_name);
  const bool is_written = std::all_of(table.columns.begin(), table.columns.end(), [&](const Column& column) {
    return std::visit([&](const auto& values) { return write_column(group, column, values); }, column.values);
  });
  return is_written && h5::share_axis(group, table.columns.front().name.c_str());
}

bool write_all(hid_t file, const StudyHead& head, const std::vector<Table>& tables) {
  h5::write_attribute(file, "format", kStudyFormat);
  h5::write_attribute(file, "study", head.study);
  h5::write_attribute(file, "long_name", head.long_name);
  write_provenance(file, own_provenance());
  return std::all_of(tables.begin(), tables.end(),
                     [file](const Table& table) { return write_table(file, table); });
}

}  // namespace

void write_study_file(const std::string& path, const StudyHead& head, const std::vector<Table>& tables) {
  AtomicFile target(path);
  constexpr std::uint64_t kExpectedBytes = 1 << 20;
  h5::Handle file = h5::create_file(target.part_path(), kExpectedBytes);
  const bool is_written = file.is_open() && write_all(file, head, tables);
  if (file.close() < 0 || !is_written) fail_to_write(path, errno == 0 ? EIO : errno);
  target.commit();
}

}  // namespace hyrax

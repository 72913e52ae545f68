#include "tools/store/table_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"
#include "tools/store/hdf5.h"
#include "tools/store/isolated_read.h"

namespace hyrax {
namespace {

constexpr hsize_t kRowsMax = 10'000'000;
constexpr std::size_t kTextBytesMax = 64 << 20;

// The order of tables and columns, which the groups of a file do not keep.
template <class Named>
std::string names_of(const std::vector<Named>& list) {
  std::string names;
  for (const Named& each : list) names += (names.empty() ? "" : " ") + each.name;
  return names;
}

std::vector<std::string> names_in(hid_t object, const char* attribute) {
  std::istringstream text(h5::read_text_attribute(object, attribute).value_or(""));
  std::vector<std::string> names;
  for (std::string name; text >> name;) names.push_back(name);
  return names;
}

bool write_table(hid_t file, const Table& table) {
  const h5::Handle group = h5::create_group(file, table.name.c_str());
  if (!group.is_open()) return false;
  h5::write_attribute(group, "long_name", table.long_name);
  h5::write_attribute(group, "columns", names_of(table.columns));
  return h5::write_columns(group, table.columns, table.columns.front().name.c_str());
}

bool write_all(hid_t file, const StudyHead& head, const std::vector<Table>& tables) {
  h5::write_attribute(file, "format", kStudyFormat);
  h5::write_attribute(file, "study", head.study);
  h5::write_attribute(file, "long_name", head.long_name);
  h5::write_attribute(file, "tables", names_of(tables));
  write_provenance(file);
  return std::all_of(tables.begin(), tables.end(),
                     [file](const Table& table) { return write_table(file, table); });
}

// Reads one file; throws Failure(bad_input) with its path.
class StudyReader {
 public:
  explicit StudyReader(const std::string& path) : path_(path), file_(h5::open_file(path)) {
    if (!file_.is_open()) refuse("is not an HDF5 file");
  }

  [[nodiscard]] StudyFile read() const {
    if (h5::read_text_attribute(file_, "format") != kStudyFormat)
      refuse("is no result file of a study (" + std::string(kStudyFormat) + ")");
    StudyFile study{.head = {h5::read_text_attribute(file_, "study").value_or(""),
                             h5::read_text_attribute(file_, "long_name").value_or("")},
                    .tables = {},
                    .provenance = read_provenance(file_)};
    for (const std::string& name : names_in(file_, "tables")) study.tables.push_back(table(name));
    if (study.tables.empty()) refuse("names no tables: an older version wrote it; run the study again");
    return study;
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const { refuse_input(path_ + ": " + sentence); }

  [[nodiscard]] Table table(const std::string& name) const {
    const h5::Handle group(H5Gopen2(file_, name.c_str(), H5P_DEFAULT), H5Gclose);
    if (!group.is_open()) refuse(name + ": is missing");
    Table table{.name = name, .long_name = h5::read_text_attribute(group, "long_name").value_or("")};
    for (const std::string& column_name : names_in(group, "columns"))
      table.columns.push_back(column(group, name, column_name));
    for (const Column& each : table.columns)
      if (length(each) != length(table.columns.front()))
        refuse(name + "/" + each.name + ": has another length than " + table.columns.front().name);
    return table;
  }

  [[nodiscard]] Column column(hid_t group, const std::string& table, const std::string& name) const {
    const h5::Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset.is_open()) refuse(table + "/" + name + ": is missing");
    const std::vector<hsize_t> shape = h5::shape_of(dataset);
    if (shape.size() != 1 || shape[0] > kRowsMax)
      refuse(table + "/" + name + ": is damaged: must be a list of at most " + std::to_string(kRowsMax) +
             " values");
    Column column{.name = name,
                  .unit = h5::read_text_attribute(dataset, "units").value_or(""),
                  .long_name = h5::read_text_attribute(dataset, "long_name").value_or(""),
                  .values = std::vector<double>()};
    if (!read_values(dataset, shape[0], column)) refuse(table + "/" + name + ": is damaged: cannot be read");
    return column;
  }

  [[nodiscard]] static bool read_values(hid_t dataset, hsize_t count, Column& column) {
    const h5::Handle type(H5Dget_type(dataset), H5Tclose);
    const H5T_class_t type_class = H5Tget_class(type);
    if (type_class == H5T_STRING)
      return H5Tis_variable_str(type) == 0 && read_texts(dataset, type, count, column);
    if (type_class == H5T_INTEGER) column.values = std::vector<std::int64_t>();
    return (type_class == H5T_INTEGER || type_class == H5T_FLOAT) &&
           h5::read_rows(dataset, 0, count, column) >= 0;
  }

  [[nodiscard]] static bool read_texts(hid_t dataset, hid_t type, hsize_t count, Column& column) {
    const std::size_t width = H5Tget_size(type);
    if (width == 0 || width > kTextBytesMax || count > kTextBytesMax / width) return false;
    std::string padded(width * count, '\0');
    if (count > 0 && H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()) < 0) return false;
    std::vector<std::string> values;
    for (hsize_t row = 0; row < count; ++row) {
      const char* const begin = padded.data() + row * width;
      values.emplace_back(begin, strnlen(begin, width));
    }
    column.values = std::move(values);
    return true;
  }

  std::string path_;
  h5::Handle file_;
};

}  // namespace

StudyFile read_study_file(const std::string& path) {
  read_isolated(path, [&] { static_cast<void>(StudyReader(path).read()); });
  return StudyReader(path).read();
}

std::string format_of_file(const std::string& path) {
  const auto format = [&] {
    const h5::Handle file = h5::open_file(path);
    return file.is_open() ? h5::read_text_attribute(file, "format").value_or("") : std::string();
  };
  read_isolated(path, [&] { static_cast<void>(format()); });
  return format();
}

void write_study_file(const std::string& path, const StudyHead& head, const std::vector<Table>& tables) {
  AtomicFile target(path);
  constexpr std::uint64_t kExpectedBytes = 1 << 20;
  h5::Handle file = h5::create_file(target.part_path(), kExpectedBytes);
  const bool is_written = file.is_open() && write_all(file, head, tables);
  if (file.close() < 0 || !is_written) fail_to_write(path, errno == 0 ? EIO : errno);
  target.commit();
}

}  // namespace hyrax

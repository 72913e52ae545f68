#include "tools/store/table_file.h"

#include <algorithm>

#include "tools/files/failure.h"
#include "tools/platform/atomic_file.h"
#include "tools/store/hdf5.h"
#include "tools/store/isolated_read.h"

namespace hyrax {
namespace {

// The order of tables and columns, which the groups of a file do not keep.
template <class Named>
std::string names_of(const std::vector<Named>& list) {
  std::string names;
  for (const Named& each : list) names += (names.empty() ? "" : " ") + each.name;
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

}  // namespace

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
  require_written(file.close() >= 0 && is_written, path);
  target.commit();
}

}  // namespace hyrax

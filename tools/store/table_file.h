// A study's tables in a file of the format `hyrax-study/1`.
//
// One group a table, one dataset a column with the attributes `units` and `long_name`; on `/` the
// attributes `format`, `study` and `tables`, and the group /provenance as trajectory files have it. `tables`,
// and `columns` of each group, give the names in order, separated by blanks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/result/table.h"
#include "tools/store/build_facts.h"

namespace hyrax {

inline constexpr std::string_view kStudyFormat = "hyrax-study/1";

struct StudyHead {
  std::string study;      ///< Its name, as `hyrax-sim study` knows it.
  std::string long_name;  ///< What was studied, in one line.
};

/// Equal content gives equal bytes. Text is fixed-length UTF-8, padded with zeros.
/// The first column is the axis (dimension scale) of the others.
/// REQUIRES: tables of different names, none of the name `provenance`; at least one column, all of one
/// length. ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON"; the file at `path` stays as it
/// was.
void write_study_file(const std::string& path, const StudyHead& head, const std::vector<Table>& tables);

/// The attribute `format` of an HDF5 file of any origin; empty if it has none or is none.
/// ERRORS: Failure(cannot_access) if it cannot be read. REQUIRES: as read_isolated.
[[nodiscard]] std::string format_of_file(const std::string& path);

}  // namespace hyrax

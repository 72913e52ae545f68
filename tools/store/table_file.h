// A study's tables in a file of the format `hyrax-study/1`.
//
// One group a table, one dataset a column with the attributes `units` and `long_name`; on `/` the
// attributes `format` and `study`, and the group /provenance as trajectory files have it.
#pragma once

#include <string>
#include <vector>

#include "sim/result/table.h"

namespace hyrax {

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

}  // namespace hyrax

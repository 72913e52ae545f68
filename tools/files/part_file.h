// A file that is not yet whole, and belongs to the one process that writes it.
#pragma once

#include <string>

namespace hyrax {

/// Its lock lives with the descriptor: that stays open until the file has its final name or is removed.
struct PartFile {
  std::string path;
  int descriptor = -1;
};

/// Makes a new, empty file beside the one that it will become: `.NAME.part`, or `.NAME.2.part` and so
/// on while others write theirs. One that a killed writer left is known by the lock that it lost, and
/// makes room for the new one.
/// ERRORS: Failure(cannot_access) where the folder cannot be written to, or too many stand there.
[[nodiscard]] PartFile make_part_file(const std::string& target);

}  // namespace hyrax

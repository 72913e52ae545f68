// A file that is not yet whole, and belongs to the one process that writes it.
#pragma once

#include <string>

namespace hyrax {

/// A new, empty file beside the one that it will become: `.NAME.part`, or `.NAME.2.part` and so on
/// while other processes write theirs. It is locked as long as its writer lives; one that a killed
/// writer left is known by that, and removed by the next one who needs its name.
class PartFile {
 public:
  /// ERRORS: Failure(cannot_access) where the folder cannot be written to, or too many stand there.
  explicit PartFile(const std::string& target);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// Removes it, if it has not become its target.
  ~PartFile();

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Puts it in the place of `target`. Returns the system's error number, or 0.
  [[nodiscard]] int become(const std::string& target);

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace hyrax

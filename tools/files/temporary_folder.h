// A folder for files that another program reads.
#pragma once

#include <string>

namespace hyrax {

/// A new folder in $TMPDIR or /tmp, removed with what is in it: by its destructor, or when SIGINT, SIGTERM or
/// SIGHUP ends the program.
class TemporaryFolder {
 public:
  /// ERRORS: Failure(cannot_access).
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Writes a file of that name in it; returns its path. ERRORS: Failure(cannot_access).
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

}  // namespace hyrax

// A file that is there whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// A new file is written beside its place, as `.NAME.part`, and renamed when it is whole. What is
/// given up, by an exception too, leaves the file at its place as it was, and so does a process that
/// is killed.
class AtomicFile {
 public:
  /// Makes the part file, empty. A symbolic link at `path` is followed: its target is replaced.
  /// ERRORS: Failure(cannot_access) where `path` is a folder, a device or a pipe, or its folder
  /// cannot be written to.
  explicit AtomicFile(const std::string& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  [[nodiscard]] const std::string& part_path() const { return part_path_; }
  /// Fills the part file. ERRORS: Failure(cannot_access).
  void write(std::string_view text) const;
  /// Puts the part file in its place. ERRORS: Failure(cannot_access).
  void commit();
  /// Puts the part file in its place if no file has that name yet. ERRORS: Failure(cannot_access), also
  /// where one has: it stays as it is.
  void commit_as_new();

 private:
  std::string path_;
  std::string part_path_;
  [[maybe_unused]] int lock_ = -1;  // Tells other writers that the part file has an owner.
};

/// "PATH: cannot be written: REASON" for the error number that the system gave.
[[noreturn]] void fail_to_write(const std::string& path, int error_number);

}  // namespace hyrax

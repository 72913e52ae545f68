// Writes a file atomically: it is complete or unchanged.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// The content is written to a part file beside the target, which replaces the target on commit. Without a
/// commit, because of an exception or a killed process too, the target is unchanged.
///
/// The part file is `.NAME.part`, or `.NAME.2.part` and so on while others write theirs. SIGINT, SIGTERM and
/// SIGHUP remove it; one left by a killed writer is recognised by the lock that it lost, and is replaced. (On
/// Windows its name has the process id, and the system removes it when the process ends, until part_path()
/// hands it over.)
class AtomicFile {
 public:
  /// Creates the part file, empty. A symbolic link at `path` is followed: its target is replaced.
  /// ERRORS: Failure(cannot_access) if `path` is a folder, a device or a pipe, its folder cannot be written
  /// to, or 100 writers have part files there.
  explicit AtomicFile(const std::string& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// For who opens the part file by its path: instead of write.
  [[nodiscard]] const std::string& part_path();
  /// Writes the content of the part file. ERRORS: Failure(cannot_access).
  void write(std::string_view text) const;
  /// Replaces the target by the part file, which gets the target's mode. ERRORS: Failure(cannot_access).
  void commit();
  /// Renames the part file to the target. ERRORS: Failure(cannot_access), also if the target exists already;
  /// it is then unchanged.
  void commit_as_new();

 private:
  std::string path_;
  std::string part_path_;
  [[maybe_unused]] int lock_ = -1;         // Shows other writers that the part file is in use.
  [[maybe_unused]] void* file_ = nullptr;  // On Windows: the part file.
};

}  // namespace hyrax

// Comma-separated values, written row by row.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tools/platform/atomic_file.h"

namespace hyrax {

/// As an output's path.
inline constexpr std::string_view kStandardOutput = "-";

/// The file is at `path` only after finish(); kStandardOutput gets text as it comes. ERRORS: every call may
/// throw Failure(cannot_access) "PATH: cannot be written: REASON".
class CsvFile {
 public:
  /// @param rows, columns how many are expected at least: fails at once if the disk is too small for them.
  CsvFile(const std::string& path, std::int64_t rows, std::size_t columns);

  void append(std::string_view text);
  void finish();

 private:
  void write();
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string path_;
  std::optional<AtomicFile> target_;  // Nothing for standard output.
  std::unique_ptr<std::FILE, Close> file_;
  std::string text_;  // Not yet written.
};

/// The bytes of so many rows. ERRORS: Failure(cannot_access) where the disk of `path` has less, instead of
/// filling it first.
std::uint64_t require_disk_space(const std::string& path, std::int64_t rows, std::uint64_t row_bytes);

}  // namespace hyrax

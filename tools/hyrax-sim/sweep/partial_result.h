// The file of a sweep that is not complete.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tools/store/ensemble_file.h"

namespace hyrax {

/// What becomes of a partial file that an earlier process left.
enum class Existing : std::uint8_t { refused, resumed, replaced };

/// Where the rows that are done are kept until the file is complete.
[[nodiscard]] std::string partial_path(const std::string& path);

/// `PATH.partial`, which is renamed to PATH when it is complete. Locked as long as this process lives: nobody
/// else writes it. It is an own file, of one name: no link is followed, no other file changed.
/// SIGINT, SIGTERM and SIGHUP print what is left and how to go on.
class PartialResult {
 public:
  /// ERRORS: Failure(cannot_access) if it cannot be written, or another process writes it; Failure(bad_input)
  /// if one exists and is refused, or is resumed and is a link.
  PartialResult(const std::string& path, const EnsembleHead& head, const Sweep& sweep, Existing existing);
  PartialResult(const PartialResult&) = delete;
  PartialResult& operator=(const PartialResult&) = delete;
  ~PartialResult();

  [[nodiscard]] const std::string& partial() const { return partial_; }
  /// What a signal says from now on. Only the thread that calls may take signals.
  void note_done(std::int64_t rows);
  /// REQUIRES: the file is complete and closed. ERRORS: Failure(cannot_access).
  void commit();

 private:
  std::string path_;
  std::string partial_;
  std::int64_t rows_;
  std::unique_ptr<const std::string> last_words_;
  int lock_ = -1;
};

}  // namespace hyrax

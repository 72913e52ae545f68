// Computes a sweep, or a part of one, into its result file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/ensemble/ensemble.h"
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

struct SweepJob {
  EnsembleHead head;
  std::string output;
  std::int64_t threads = 1;
  Existing existing = Existing::refused;
};

struct SweepOutcome {
  std::int64_t rows = 0;
  std::int64_t rows_resumed = 0;  ///< Done by an earlier process.
  StepTally tally;                ///< Of the rows computed now.
};

/// Computes what is not done yet; the same file whatever the threads and however often it was resumed.
/// ERRORS: as PartialResult and EnsembleWriter.
[[nodiscard]] SweepOutcome compute_sweep(const Core& core, const Sweep& sweep, const SweepJob& job);

struct MergeOutcome {
  EnsembleHead head;
  std::vector<std::string> missing;  ///< Paths of the missing parts; if there are any, nothing was written.
};

/// Joins the parts of a sweep into one result file.
/// ERRORS: Failure(bad_input) if a file is no part of the same sweep, or given twice; Failure(cannot_access).
[[nodiscard]] MergeOutcome merge_parts(const std::vector<std::string>& paths, const std::string& output);

/// "FILE.part-I-of-N.h5" for FILE.h5.
[[nodiscard]] std::string part_path(const std::string& path, const WorkPart& part);

}  // namespace hyrax

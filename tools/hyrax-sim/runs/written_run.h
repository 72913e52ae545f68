// A scenario played into a file: a trajectory, or comma-separated values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "tools/hyrax-sim/drift/drift_run.h"

namespace hyrax {

/// What of the errors against the reference goes into the file, too.
struct StoredDrift {
  DriftOptions options;
  bool stores_rows = false;  ///< Of every recorded row, beside those of arcs and contacts.
};

struct WriteOptions {
  ReplayOptions replay;
  std::optional<StoredDrift> drift;  ///< Measured in a second replay.
};

struct WrittenRun {
  RunSummary summary;
  std::int64_t rows_recorded = 0;
  std::optional<DriftRun> drift;
};

/// Writes rows alone where `output` ends in ".csv". Progress is shown. ERRORS: Failure(cannot_access) where
/// `output` cannot be written.
[[nodiscard]] WrittenRun write_run(const std::string& output, const Scenario& scenario,
                                   const WriteOptions& options);

}  // namespace hyrax

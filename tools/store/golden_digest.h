// The text beside a golden file: a run in a few lines that a review can read.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// @param reason given at the blessing.
[[nodiscard]] std::string golden_digest_text(const StoredRun& run, const RunSummary& summary,
                                             const std::string& reason);

/// The state hash that a digest names. ERRORS: Failure(cannot_access) where it cannot be read,
/// Failure(bad_input) where it names none.
[[nodiscard]] std::string read_digest_hash(const std::string& path);

}  // namespace hyrax

// The text beside a golden file: a run in a few lines that a review can read.
#pragma once

#include <optional>
#include <string>

#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

/// @param reason given at the blessing.
/// @param margin how near the run is to being another one, in words; no line where it is empty.
[[nodiscard]] std::string golden_digest_text(const StoredRun& run, const RunSummary& summary,
                                             const std::string& reason, const std::string& margin = "");

/// The reason that a digest gives, empty where it gives none.
[[nodiscard]] std::string digest_reason(const std::string& text);

/// The margin that a digest gives, empty where it gives none.
[[nodiscard]] std::string digest_margin(const std::string& text);

/// Where a digest differs from the one that blessing the run now would write, in words; nothing where
/// it does not. The scenario's name is left out, as it is part of no comparison.
[[nodiscard]] std::optional<std::string> digest_fault(const std::string& kept, const std::string& fresh);

/// The state hash that a digest names. ERRORS: Failure(cannot_access) where it cannot be read,
/// Failure(bad_input) where it names none.
[[nodiscard]] std::string read_digest_hash(const std::string& path);

}  // namespace hyrax

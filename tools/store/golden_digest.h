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

/// The first line in which a digest differs from the one that blessing the run now would write, in words;
/// nothing where none does.
[[nodiscard]] std::optional<std::string> digest_fault(const std::string& kept, const std::string& fresh);

}  // namespace hyrax

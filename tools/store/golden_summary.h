// The summary beside a golden file: a run in a few lines that a review can read, and two checksums: of the
// run with these lines, and of the .h5 file.
#pragma once

#include <string>

#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/stored_run.h"
#include "sim/trajectory/waypoints.h"

namespace hyrax {

/// What a summary says besides its run.
struct GoldenChecksums {
  std::string contents;  ///< contents_checksum of the stored run.
  std::string file;      ///< file_checksum of the .h5 file.
  std::string core;      ///< AcceptedCore::name of the core that was blessed; empty: written before 0.2.
};

/// XXH3-128, as 32 hex digits, over a run's scenario (without name, description, $schema and expect), physics
/// model, constants, state hash, times, contacts, inputs and keyframes.
[[nodiscard]] std::string contents_checksum(const StoredRun& run);

/// XXH3-128 over a file's bytes. ERRORS: Failure(cannot_access) if it cannot be read.
[[nodiscard]] std::string file_checksum(const std::string& path);

/// The run for review in a diff: what moved shows in lines of decimal px.
/// @param reason given to bless. REQUIRES: one line.
/// @param margin how far the start may move before a contact changes; no line if empty.
[[nodiscard]] std::string golden_summary_text(const StoredRun& run, const RunSummary& summary,
                                              const Waypoints& waypoints, const std::string& reason,
                                              const std::string& margin, const GoldenChecksums& checksums);

/// A summary's lines with the reason, which follows on them, and the checksums' line.
[[nodiscard]] std::string with_checksums(const std::string& lines, const std::string& reason,
                                         const std::string& contents, const std::string& file);

/// Whether a summary ends with the checksum of these contents and of its own lines, all but the reason's
/// text, and that of the file. Then a run of these contents agrees with the golden file in everything that a
/// comparison looks at, and neither need be read nor written again to tell.
[[nodiscard]] bool has_checksums(const std::string& text, const std::string& contents,
                                 const std::string& file);

}  // namespace hyrax

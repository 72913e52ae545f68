// The summary of a golden file (GOLDEN.txt): reads it, and words that a run's summary has in common with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/trajectory/run_summary.h"

namespace hyrax {

inline constexpr std::string_view kStateHashKey = "state hash: ";
inline constexpr std::string_view kCoreKey = "core: ";
inline constexpr std::string_view kReasonKey = "reason: ";
inline constexpr std::string_view kChecksumsKey = "checksums: ";

/// "right 1, ground 5 bounces, then resting contact from row 306".
/// @param names_all walls without a contact, too.
[[nodiscard]] std::string contacts_text(const RunSummary& run, bool names_all = false);

/// What is wrong with a summary whose lines end in CR LF.
inline constexpr char kConvertedLineEnds[] =
    "its line ends were converted to CR LF; a line `golden/** -text` in .gitattributes keeps Git from it";

/// The rest of the first line that begins with the key, not counting the first line of all; empty: there is
/// none.
[[nodiscard]] std::string line_value(const std::string& text, std::string_view key);

/// Whether bless wrote the text: it has the first line, the state hash and the checksums of a summary.
[[nodiscard]] bool is_summary(const std::string& text);

/// The reason that a summary states; empty if it states none.
[[nodiscard]] std::string summary_reason(const std::string& text);

/// The state hash that a summary states, 32 hex digits; empty if it states none, or something else.
[[nodiscard]] std::string summary_state_hash(const std::string& text);

/// The core that a summary names, 32 hex digits; empty if it names none, or something else.
[[nodiscard]] std::string summary_core(const std::string& text);

/// The checksum of the .h5 file that a summary ends with; nothing if it does not end with one.
[[nodiscard]] std::optional<std::string> summary_file_checksum(const std::string& text);

}  // namespace hyrax

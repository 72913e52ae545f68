// Reads and writes sweeps in the format `hyrax-sweep/1`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/scenario/sweep.h"

namespace hyrax {

inline constexpr std::string_view kSweepFormat = "hyrax-sweep/1";

struct SweepFile {
  Sweep sweep;
  /// The sweep complete in itself: its base inside and without `expect`, defaults filled in. Two sweeps are
  /// the same if this text is.
  std::string text;
  std::string base_path;  ///< Empty if the base was inside the file.
};

/// Reads a sweep file, and its base.
/// ERRORS: Failure(cannot_access) if a file cannot be read; Failure(bad_input) with a line for every error,
/// "PATH: POINTER: RULE (found VALUE)", or for the first invalid member, "PATH: member I: POINTER: ...".
[[nodiscard]] SweepFile load_sweep(const std::string& path);

/// Which members are checked: all of them, or, of a text that was checked before, the first one.
enum class SweepCheck : std::uint8_t { all_members, first_member };

/// A sweep from its text. @param source names it in messages.
[[nodiscard]] SweepFile parse_sweep(std::string_view text, const std::string& source,
                                    SweepCheck check = SweepCheck::all_members);

/// A member as a scenario of its own, named after the base and the member.
[[nodiscard]] Scenario member_scenario(const Sweep& sweep, std::int64_t member);

}  // namespace hyrax

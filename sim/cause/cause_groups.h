// Why the runs of two programs differ: runs that differ, grouped by their causes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/trajectory/stored_run.h"

namespace hyrax {

enum class CauseKind : std::uint8_t {
  non_finite,  ///< The run's state becomes non-finite.
  core,        ///< The accepted core gives the golden file's bits, this program's core does not.
  clock,       ///< Other frame times.
  input,       ///< Other inputs, or an input with another effect.
  scenario,    ///< The scenario's own text.
  golden,      ///< The golden file was changed after it was blessed.
  unknown
};
inline constexpr std::array<std::string_view, 7> kCauseKindNames = {"non_finite", "core",   "clock",  "input",
                                                                    "scenario",   "golden", "unknown"};
[[nodiscard]] constexpr std::string_view name_of(CauseKind kind) {
  return kCauseKindNames[static_cast<std::size_t>(kind)];
}

inline constexpr std::string_view kNotRepeated =
    "this program does not repeat itself: played twice, the scenario gives different bits";

struct Cause {
  CauseKind kind = CauseKind::unknown;
  std::string detail;  ///< As "GRAVITY 1200 -> 1250"; of an unknown one, what is known.
  bool operator==(const Cause&) const = default;
};

/// A scenario whose run is not the golden file's.
struct DifferingRun {
  const StoredRun& golden;
  const StoredRun& fresh;            ///< The run of this program.
  std::string scenario_change;       ///< As "/start/vx_px_per_s 40000 -> 40001"; empty: both play the same.
  bool is_golden_as_blessed = true;  ///< Else the file was changed after it was blessed.
  bool names_accepted_core =
      false;                ///< The golden file was blessed with the accepted core, or agreed with it.
  bool is_repeated = true;  ///< Else another play of the scenario is known to have given other bits.
};

/// The cores that the runs are judged by.
struct CauseBase {
  const Core& program;               ///< Played the fresh runs.
  const Core* accepted = nullptr;    ///< Plays the accepted core's step; nullptr: there is none to play.
  bool has_further_members = false;  ///< The accepted core; then a row is not all of a state.
  std::string why_not_played;        ///< Why there is none, as a clause; else empty.
  bool is_same_core = false;         ///< Header and step are the accepted ones, or proved equal.
  std::string core_change;           ///< Else what changed, as "GRAVITY 1200 -> 1250".
  bool calls_libm = false;  ///< The accepted step calls functions whose bits differ between libraries.
};

/// Runs of one cause.
struct CauseGroup {
  Cause cause;
  std::vector<std::size_t> runs;  ///< By their index, in order.
};

/// Each run in one group: known causes by their size, then unknown ones. Of a program that does not give the
/// fresh run again nothing else is said. The cause is the core where the
/// accepted step gives the golden file, frame times and contacts included. Else in this order: frame times,
/// inputs, the scenario's own text, a golden file that was changed, unknown.
[[nodiscard]] std::vector<CauseGroup> group_by_cause(const std::vector<DifferingRun>& runs,
                                                     const CauseBase& base);

}  // namespace hyrax

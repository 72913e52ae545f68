// Plays random scenarios until a rule is broken, or time or runs are over.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/scenario/scenario.h"
#include "tools/app/command_line/part.h"
#include "tools/app/search/broken_rule.h"

namespace hyrax {

struct FuzzLimits {
  std::uint64_t seed = 1;
  std::optional<std::int64_t> runs;  ///< Of all parts.
  double time_s = 60.0;              ///< Where no number of runs is given.
  WorkPart part;
};

struct FuzzFailure {
  std::uint64_t run = 0;
  Scenario scenario;
  BrokenRule broken;
};

struct FuzzOutcome {
  std::int64_t runs = 0;          ///< Played.
  std::int64_t not_compared = 0;  ///< Of them; the other program did not end in time.
  double elapsed_s = 0.0;
  std::optional<FuzzFailure> failure;  ///< The first one, in order of the runs.
};

/// Plays runs on all processors; shows progress. With a number of runs the outcome does not depend on how
/// many processors there are.
/// @param other nullptr: invariants alone; else also the state hash of that program.
[[nodiscard]] FuzzOutcome fuzz(const FuzzLimits& limits, const OtherProgram* other);

}  // namespace hyrax

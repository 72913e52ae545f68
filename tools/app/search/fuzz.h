// Random scenarios, held to the invariants on all processors.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/sweep.h"
#include "sim/search/invariant.h"

namespace hyrax {

struct FuzzLimits {
  std::uint64_t seed = 1;
  std::optional<std::int64_t> runs;  ///< Of all parts.
  double time_s = 60.0;              ///< Where no number of runs is given.
  WorkPart part;
  std::vector<std::string> without;  ///< Names of invariants that may be broken.
};

/// The names of the invariants that a random scenario can break.
[[nodiscard]] std::vector<std::string> fuzzed_rules();

struct FuzzFailure {
  std::uint64_t run = 0;
  Scenario scenario;
  Invariant broken{};
  std::string found;  ///< "-3 px at step 4".
};

struct FuzzOutcome {
  std::int64_t runs = 0;  ///< Played.
  double elapsed_s = 0.0;
  std::optional<FuzzFailure> failure;  ///< The first one, in order of the runs.
};

/// Plays runs on all processors; shows progress. With a number of runs the outcome does not depend on how
/// many processors there are.
[[nodiscard]] FuzzOutcome fuzz(const Core& core, const FuzzLimits& limits);

}  // namespace hyrax

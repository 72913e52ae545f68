// The smallest scenario of which a run still says the same.
#pragma once

#include <optional>
#include <string>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/search/invariant.h"
#include "sim/search/shrink.h"
#include "tools/app/library/shrink_flow.h"

namespace hyrax {

struct ShrunkRun {
  std::string kept;  ///< As "final_x_px is above its range", "signal 11 (SIGSEGV)".
  Shrunk shrunk;
};

/// Keeps the first of these that a run of the scenario says: the signal that ends it, or that it does not
/// end; the value that becomes non-finite; a rule of `expect` that is broken, and on which side; a broken
/// invariant; other bits than those of the accepted core. Works in a child process, and gives each run one of
/// its own if one ends it. Shows progress.
/// @param path of the scenario, to whose library the accepted core belongs.
/// ERRORS: Failure(bad_input) "PATH: nothing to keep: ...".
[[nodiscard]] ShrunkRun shrink_run(const Core& core, const std::string& path, const Scenario& scenario,
                                   const ShrinkLimits& limits);

/// The smallest scenario that breaks the same invariant, or in which the core throws the same, by a core
/// whose runs end; shows progress. @param thrown CoreFailure::without_row; empty: of an invariant.
[[nodiscard]] Shrunk shrink_broken(const Core& core, const Scenario& scenario,
                                   const std::optional<Invariant>& invariant, const std::string& thrown = "");

}  // namespace hyrax

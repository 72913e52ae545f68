// The rules that fuzzing holds a scenario to, and the smallest scenario that breaks one.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/scenario/scenario.h"
#include "sim/search/run_check.h"
#include "sim/search/shrink.h"
#include "tools/hyrax-sim/search/other_program.h"

namespace hyrax {

/// What a scenario broke.
struct BrokenRule {
  std::optional<Invariant> invariant;  ///< Nothing: the state hash is not that of the other program.
  std::string found;                   ///< "-3 px at step 4", "0123... here, 4567... there".
  std::string other_end;               ///< How the other program ended, if it printed no state hash.

  [[nodiscard]] std::string name() const;  ///< "clamp", "state-hash".
  [[nodiscard]] std::string rule() const;  ///< In words.
};

/// The first invariant that the run breaks though the listing keeps it.
[[nodiscard]] std::optional<BrokenRule> broken_invariant(const Scenario& scenario, const CheckedRun& run);

/// @param other a state hash, or how the other program ended instead; empty if it is not known.
[[nodiscard]] std::optional<BrokenRule> different_hash(const Digest& own, const std::string& other);

/// The scenario's state hash against the other program's.
[[nodiscard]] std::optional<BrokenRule> different_hash(const Scenario& scenario, const OtherProgram& other);

/// The smallest scenario that breaks the same rule; shows progress.
/// @param other needed only where the rule is not an invariant.
[[nodiscard]] Shrunk shrink_broken(const Scenario& scenario, const BrokenRule& broken,
                                   const OtherProgram* other);

/// `shrink`, showing progress.
[[nodiscard]] Shrunk shrink_with_progress(const Scenario& scenario,
                                          const std::function<bool(const Scenario&)>& fails,
                                          std::int64_t trials_max);

}  // namespace hyrax

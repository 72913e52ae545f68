// The rules that fuzzing holds random scenarios to, and the smallest scenario that breaks one.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/sweep.h"
#include "sim/search/run_check.h"
#include "sim/search/shrink.h"
#include "tools/files/child_process.h"

namespace hyrax {

/// Another build of hyrax-sim, which computes the state hash of scenarios.
class OtherProgram {
 public:
  using SteadyClock = std::chrono::steady_clock;

  /// Plays a scenario with it, to see that it is a hyrax-sim.
  /// @param option for the message, as "hyrax-sim fuzz: --against".
  /// @param deadline see set_deadline.
  /// @param limit_s for each process.
  /// ERRORS: Failure(cannot_access) if it cannot be started; Failure(bad_input) if it prints no state hash.
  OtherProgram(std::string program, const std::string& option,
               std::optional<SteadyClock::time_point> deadline = std::nullopt, double limit_s = 60.0);

  /// From then on no process is started, and one that runs is ended.
  void set_deadline(SteadyClock::time_point deadline) { deadline_ = deadline; }
  [[nodiscard]] bool is_over() const { return deadline_ && SteadyClock::now() >= *deadline_; }

  /// How many scenarios one process plays best: `check`, which writes no file, takes some 0.1 ms for each,
  /// `run` some 3 ms. Starting the process takes 5 ms.
  [[nodiscard]] std::size_t batch() const { return uses_check_ ? 256 : 16; }

  /// The state hash of each scenario; of one that it prints no hash for, how it ended instead, as
  /// "signal 11 (exit code 139)"; empty if the deadline came before. One process plays all of them; only if a
  /// hash is missing is each played alone. REQUIRES: scenarios of different names.
  [[nodiscard]] std::vector<std::string> state_hashes(std::span<const Scenario> scenarios) const;

 private:
  enum class Query { run, check };
  [[nodiscard]] std::vector<std::string> query(Query command, std::span<const Scenario> scenarios,
                                               ChildEnd& end) const;

  [[nodiscard]] double left_s() const;

  std::string program_;
  double limit_s_;
  std::optional<SteadyClock::time_point> deadline_;
  bool uses_check_ = false;
};

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
[[nodiscard]] std::optional<BrokenRule> different_hash(const Core& core, const Scenario& scenario,
                                                       const OtherProgram& other);

/// The smallest scenario that breaks the same rule; shows progress.
/// @param other needed only where the rule is not an invariant.
[[nodiscard]] Shrunk shrink_broken(const Core& core, const Scenario& scenario, const BrokenRule& broken,
                                   const OtherProgram* other);

/// `shrink`, showing progress.
[[nodiscard]] Shrunk shrink_with_progress(const Core& core, const Scenario& scenario,
                                          const std::function<bool(const Scenario&)>& fails,
                                          std::int64_t trials_max);

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
[[nodiscard]] FuzzOutcome fuzz(const Core& core, const FuzzLimits& limits, const OtherProgram* other);

}  // namespace hyrax

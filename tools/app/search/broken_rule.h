// The rules that fuzzing holds a scenario to, and the smallest scenario that breaks one.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
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

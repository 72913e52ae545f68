// This program's core against the accepted one of a golden folder, and the causes of runs that differ.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/cause/cause_groups.h"
#include "sim/cause/header_change.h"
#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/search/beyond_library.h"
#include "sim/trace/step_difference.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/library/difference_group.h"

namespace hyrax {

/// A difference of two steps that no scenario of the library shows.
struct UnnoticedDifference {
  std::string text;
  std::optional<Scenario> scenario;  ///< Shows it, where the search found a step.
  std::string
      consequence;  ///< As "played for 5 s, ends 12.3 px apart"; without one, the names of `unrecorded`.
  std::int64_t steps_tried = 0;
  MemberBits unrecorded = 0;  ///< Further members that it decides, if no row depends on these.
};

/// What the scenarios of libraries with one golden folder show of the differences of two cores.
struct LibraryNotice {
  bool is_noticed = false;  ///< A scenario shows a difference.
  std::vector<UnnoticedDifference> unnoticed;
};

/// Plays the libraries by the accepted core, and searches for a scenario for each difference that no row of
/// them shows: the same on every machine. Scenarios that cannot be read are left out: whoever checks them
/// reports it.
[[nodiscard]] LibraryNotice notice(const StepPair& steps, const Core& accepted, const Core& program,
                                   const std::vector<std::string>& scenarios_folders);

struct CoreVerdict : CoreFinding, LibraryNotice {
  std::vector<HeaderChange> changes;
  std::set<std::uint32_t> paths_taken;  ///< By the scenarios checked; only where asked for.
  std::optional<BeyondLibrary> beyond;  ///< Of changed and not_proved.
  std::string why_not_beyond = "the library was not played whole";  ///< Else.
};

class CoreCheck {
 public:
  /// Reads and compares; refers to the core. What is damaged or missing becomes part of the verdict.
  /// @param commands that the verdict suggests; empty ones are left out.
  CoreCheck(const Core& core, const std::string& golden_folder, CoreCommands commands);

  [[nodiscard]] const CoreVerdict& verdict() const { return verdict_; }

  /// What the causes of differing runs are judged by. Refers to this.
  [[nodiscard]] CauseBase base() const;
  /// Whether a golden file of that core can be judged by the accepted one.
  [[nodiscard]] bool covers(const std::string& core_name) const;

  /// Scenarios differ, these runs because of the core: counts which each changed constant reproduces alone.
  void take_core_runs(const std::vector<const StoredRun*>& fresh);
  /// Plays all libraries of the golden folder by the accepted step, and looks for steps that show what it
  /// does not notice; and plays so many random flings by both steps.
  void judge_differences(const std::vector<std::string>& scenarios_folders, std::int64_t flings);
  /// A scenario took these paths of the program's step.
  void take_paths(const std::set<std::uint32_t>& paths) {
    verdict_.paths_taken.insert(paths.begin(), paths.end());
  }

 private:
  void compare();
  void measure_beyond_library(std::int64_t flings);
  [[nodiscard]] std::string unrecorded_sentence();
  [[nodiscard]] std::string why_not_played() const;

  const Core& core_;
  CoreVerdict verdict_;
  std::optional<AcceptedCore> accepted_;
  // The traced steps, where they are complete, and what plays the accepted one.
  std::optional<TracedStep> accepted_step_, program_step_;
  std::optional<Core> accepted_core_;
};

/// The checks of several golden folders, each made when first asked for.
class CoreChecks {
 public:
  /// Refers to the core. @param scenarios,golden_option as of core_commands.
  CoreChecks(const Core& core, const std::vector<std::string>& scenarios, const std::string& golden_option);

  [[nodiscard]] CoreCheck& of(const std::string& golden_folder) {
    return checks_.try_emplace(golden_folder, core_, golden_folder, commands_).first->second;
  }
  /// Of each golden folder, by all of these libraries that have it: what one shows another need not.
  void judge_differences(const std::vector<Library>& libraries, std::int64_t flings);
  /// In order of the folders' names.
  [[nodiscard]] std::vector<const CoreVerdict*> verdicts() const {
    std::vector<const CoreVerdict*> verdicts;
    for (const auto& [folder, check] : checks_) verdicts.push_back(&check.verdict());
    return verdicts;
  }

 private:
  const Core& core_;
  CoreCommands commands_;
  std::map<std::string, CoreCheck> checks_;
};

/// The verdict as text: complete lines; empty where the core is the accepted one.
/// @param is_alone else the verdict names its golden folder.
/// @param scenarios_agree all that were checked: then the core can be accepted as it is.
[[nodiscard]] std::string core_text(const CoreVerdict& verdict, bool is_alone = true,
                                    bool scenarios_agree = false);
/// {"golden", "status", "why", "paths", "paths_taken", "changes", "unnoticed", "beyond"}, an entry of
/// "cores".
[[nodiscard]] Json core_json(const CoreVerdict& verdict);

/// The end of the exact fling by these constants, without which none is known.
[[nodiscard]] ExactEnd exact_end(const std::optional<Constants>& constants);

/// What a changed core does beyond its library: complete lines, indented by two.
[[nodiscard]] std::string beyond_text(const BeyondLibrary& beyond);
/// {"flings", "other_bits", ...}
[[nodiscard]] Json beyond_json(const BeyondLibrary& beyond);

/// The verdict on a scenario of such a group.
[[nodiscard]] inline const PairVerdict& pair_of(const ScenarioVerdict& scenario) {
  return static_cast<const PairVerdict&>(scenario);
}

/// The non_finite_text of a run that differs; empty where it stays finite.
[[nodiscard]] std::string non_finite_text(const PairVerdict& scenario);

/// Runs that become non-finite first; then known causes by their size, then unknown ones. The cores take the
/// runs that differ because of them.
/// @param scenarios whose runs are not their golden files'; they outlive the groups.
[[nodiscard]] std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                                          CoreChecks& cores);

}  // namespace hyrax

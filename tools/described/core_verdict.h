// A core that describes itself against the accepted one of a golden folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cause/header_change.h"
#include "sim/described/described_core.h"
#include "sim/trace/step_difference.h"
#include "tools/app/core/accepted_core.h"
#include "tools/described/judged_run.h"

namespace hyrax {

/// Said of what needs the paper's interface: random flings beyond the library, and the search for changes
/// that no scenario notices.
inline constexpr std::string_view kNotDescribedYet = "not for cores that describe themselves yet";

/// This program's core, without a reason. Its step is held to the core.
[[nodiscard]] AcceptedCore program_core(const DescribedCore& core);

/// Another default of a parameter or of the state.
struct DefaultChange {
  SettableList list = SettableList::parameters;
  std::size_t place = 0;
  Word before = 0;
};

struct DescribedChange : HeaderChange {
  std::optional<DefaultChange> of_default = {};
};

struct DescribedCoreVerdict : CoreFinding {
  std::vector<DescribedChange> changes = {};
  std::vector<ValueDifference> differences = {};  ///< Of both steps, where both are complete.
  /// Where both steps are complete, and the descriptions the same.
  std::optional<TracedStep> accepted_step = {};

  /// "gravity 980 -> 1000; the core changed at lines 7 and 18"; empty: nothing changed.
  [[nodiscard]] std::string sentence() const;
  /// Complete lines; empty of an accepted one. @param scenarios_agree else the core is accepted with them.
  [[nodiscard]] std::string text(bool scenarios_agree) const;
  [[nodiscard]] Json json() const;
};

/// These runs differ from their golden files: counts which of them each changed default gives alone, if it is
/// set to what it was, and each changed constant in the accepted step.
void count_reproduced(const DescribedCore& core, const std::vector<const DescribedRun*>& runs,
                      DescribedCoreVerdict& verdict);

/// @param scenarios, golden_option as given, for the command that accepts.
[[nodiscard]] DescribedCoreVerdict verdict_on_core(const DescribedCore& core,
                                                   const std::string& golden_folder,
                                                   const std::vector<std::string>& scenarios,
                                                   const std::string& golden_option);

}  // namespace hyrax

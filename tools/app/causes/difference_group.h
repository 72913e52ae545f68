// Scenarios whose runs are not their golden files', grouped by cause: what `check` and `bless` show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/cause/cause.h"
#include "sim/compare/comparison.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/files/json.h"

namespace hyrax {

struct DifferenceGroup {
  Cause cause;
  std::vector<const PairVerdict*> scenarios;  ///< The worst first: by the largest distance, then by contacts.
  DifferenceClass difference = DifferenceClass::rounding;  ///< The widest.
  double max_px = 0.0;                                     ///< Largest distance of two rows of the same step.
  std::int64_t contacts_moved = 0;                         ///< Moved, only old and only new, summed.
  bool are_contacts_cut = false;                           ///< At least so many: ContactChanges::is_cut.
  std::optional<double> rest_shift_px;  ///< Largest distance of the final rows where both runs have settled.
};

/// The non_finite_text of a run that differs; empty where it stays finite.
[[nodiscard]] std::string non_finite_text(const PairVerdict& scenario);

/// Runs that become non-finite first; then known causes by their size, then unknown ones. The cores take the
/// runs that differ because of them.
/// @param scenarios whose runs are not their golden files'; they outlive the groups.
[[nodiscard]] std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                                          CoreChecks& cores);

/// {"operation", "detail", ...}, an entry of "groups"; scenarios in order of their paths.
[[nodiscard]] Json group_json(const DifferenceGroup& group);

/// "93 of 99 scenarios differ: GRAVITY 1200 -> 1250; the accepted core gives all 93 golden files.", in one
/// line.
struct CauseSentence {
  std::string subject;    ///< "93 of 99 scenarios".
  std::string verb;       ///< "differ".
  std::string predicate;  ///< ": GRAVITY ...".
  [[nodiscard]] std::string text() const { return subject + " " + verb + predicate; }
};
[[nodiscard]] CauseSentence cause_sentence(const DifferenceGroup& group, std::size_t checked);

/// "Contacts moved: at most 812.3 px apart; 57 contacts moved; comes to rest up to 31 px away." One line.
[[nodiscard]] std::string consequence_sentence(const DifferenceGroup& group);

/// Of one scenario of the group: "93.2 px at step 410 (6.833 s), 3 contacts moved, comes to rest at x 1237.8
/// -> 1240.1, y 952 -> 952".
[[nodiscard]] std::string scenario_consequence(const PairVerdict& scenario);

/// Runs that become non-finite, what changed in the cores, the other groups: of each both sentences and the
/// three worst scenarios.
void print_groups(const std::vector<DifferenceGroup>& groups, const std::vector<const CoreVerdict*>& cores,
                  std::size_t checked);

}  // namespace hyrax

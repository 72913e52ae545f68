// Groups of scenarios as text.
#pragma once

#include <cstddef>
#include <string>

#include "tools/app/causes/difference_group.h"

namespace hyrax {

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

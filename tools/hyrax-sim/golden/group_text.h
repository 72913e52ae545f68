// Groups of scenarios as text.
#pragma once

#include <cstddef>
#include <string>

#include "tools/hyrax-sim/golden/difference_group.h"

namespace hyrax {

/// How many scenarios differ, and by how many causes.
struct GroupCounts {
  std::size_t checked = 0;
  std::size_t groups = 0;
};

/// "93 of 99 scenarios differ, all by one cause: GRAVITY 1200 -> 1250 reproduces 93 of 93.", in one line.
struct CauseSentence {
  std::string subject;    ///< "93 of 99 scenarios".
  std::string verb;       ///< "differ".
  std::string predicate;  ///< ", all by one cause: ...".
  [[nodiscard]] std::string text() const { return subject + " " + verb + predicate; }
};
[[nodiscard]] CauseSentence cause_sentence(const DifferenceGroup& group, const GroupCounts& counts);

/// "Contacts moved: at most 812.3 px apart; 57 contacts moved; comes to rest up to 31 px away." One line.
[[nodiscard]] std::string consequence_sentence(const DifferenceGroup& group);

/// Of one scenario of the group: "93.2 px at step 410 (6.833 s), 3 contacts moved, comes to rest at x 1237.8
/// -> 1240.1, y 952 -> 952".
[[nodiscard]] std::string scenario_consequence(const DifferingScenario& scenario);

/// Prints both sentences and the three worst scenarios.
void print_group(const DifferenceGroup& group, const GroupCounts& counts);

}  // namespace hyrax

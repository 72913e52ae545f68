// What is said of contacts where a list of them is full.
#include "tools/app/causes/group_text.h"

#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"

namespace hyrax {
namespace {

TEST(GroupText, OfAFullListOfContactsSaysTheFewest) {
  PairVerdict scenario;
  scenario.path = "scenarios/full.json";
  scenario.comparison.contacts.is_cut = true;
  CoreChecks cores(shipped_core(), {}, "");
  for (const std::string text : {"no recorded contact moved", "at least 3 contacts moved"}) {
    const DifferenceGroup group = group_by_cause({&scenario}, cores).front();
    EXPECT_TRUE(consequence_sentence(group).ends_with("no position differs, " + text + "."));
    EXPECT_EQ(scenario_consequence(scenario), "no position differs, " + text);
    scenario.comparison.contacts.moved.resize(3);
  }
}

}  // namespace
}  // namespace hyrax

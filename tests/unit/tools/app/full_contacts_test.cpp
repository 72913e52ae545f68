// What is said of contacts where a list of them is full.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/diff/trajectory_diff.h"

namespace hyrax {
namespace {

TEST(FullContacts, AreSaidToBeTheFewestThatMoved) {
  PairVerdict scenario;
  scenario.path = "scenarios/full.json";
  ContactChanges& contacts = scenario.comparison.contacts;
  contacts.is_cut = true;
  CoreChecks cores(shipped_core(), {}, "");
  for (const std::string text : {"no recorded contact moved", "at least 3 contacts moved"}) {
    const DifferenceGroup group = group_by_cause({&scenario}, cores).front();
    EXPECT_TRUE(consequence_sentence(group).ends_with("no position differs, " + text + "."));
    EXPECT_EQ(scenario_consequence(scenario), "no position differs, " + text);
    EXPECT_EQ(contacts_sentence(contacts), text + (contacts.is_none() ? "" : ", 0 vanished, 0 appeared"));
    contacts.moved.resize(3);
  }
}

}  // namespace
}  // namespace hyrax

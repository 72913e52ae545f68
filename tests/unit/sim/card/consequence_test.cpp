#include <gtest/gtest.h>

#include "sim/card/card.h"

namespace hyrax {
namespace {

Band band(double median) { return {100, median, 0.5 * median, 2.0 * median}; }

// Flings that land elsewhere, and a spread over displays that changes by more.
Card changed_card() {
  Card card{.flings = 100, .scenarios = 3};
  card.random.classes.of_class[0] = 100;
  card.random.distance_px = band(10.0);
  card.displays.spread_px = {band(900.0), band(60.0)};
  return card;
}

ScenarioChange far_away(double px) {
  ScenarioChange changed{.path = "hard/corner.json", .change = {.has_same_bits = false}};
  changed.change.largest = WorstDistance{.px = px};
  return changed;
}

TEST(Consequence, IsTheWidestShift) {
  Card card = changed_card();
  EXPECT_EQ(
      consequence_of(card),
      "The same fling on displays of 24 to 1000 Hz lands 60 px apart instead of 900 px (median of 100).");
  card.displays.spread_px.after = band(895.0);
  EXPECT_EQ(consequence_of(card),
            "A fling lands 10 px from where it did (median; one in ten 20 px or more).");
}

TEST(Consequence, WhatDoesNotEndWellComesFirst) {
  Card card = changed_card();
  card.library.changed = {far_away(1.0)};
  card.library.changed[0].change.no_longer_settles = true;
  EXPECT_EQ(consequence_of(card), "The sprite no longer settles in 1 of 3 scenarios.");
  card.random.no_longer_settle = 3;
  EXPECT_EQ(consequence_of(card), "3 of 100 flings no longer settle within 20 s.");
  card.library.changed[0].change.became_non_finite = true;
  EXPECT_EQ(consequence_of(card), "The sprite vanishes in 1 of 3 scenarios: its state is no longer finite.");
}

TEST(Consequence, OfFewRunsNamesTheWorst) {
  Card card{.flings = 100, .scenarios = 3};
  card.random.classes.same_bits = 100;
  EXPECT_EQ(consequence_of(card), "None: every row has the same bits.");
  const char* const farthest = "Most flings look the same; the farthest of 100 lands 7 px from where it did.";
  card.displays.distance_max_px = 7.0;  // On another display than the scenarios' and the flings'.
  EXPECT_EQ(consequence_of(card), farthest);
  card.displays.distance_max_px = 0.0;
  card.random.classes.same_bits = 99;
  EXPECT_TRUE(card.has_other_bits());
  EXPECT_EQ(consequence_of(card), "None that can be seen: only speeds differ.");
  card.random.classes.same_bits = 100;
  card.library.changed = {far_away(0.0)};
  EXPECT_TRUE(card.has_other_bits());
  EXPECT_EQ(consequence_of(card), "None that can be seen: only speeds differ.");
  card.library.changed = {far_away(0.25)};
  EXPECT_EQ(consequence_of(card), "None that can be seen: no sprite is more than 0.25 px from where it was.");
  card.random.distance_max_px = 7.0;
  EXPECT_EQ(consequence_of(card), farthest);
  card.library.changed = {far_away(0.25), far_away(40.0)};
  EXPECT_EQ(consequence_of(card),
            "Most flings look the same; in hard/corner.json the sprite is up to 40 px from where it was.");
}

// Where every row of scenarios and flings has the same bits.
TEST(Consequence, CountsHardCasesAndRandomRuns) {
  Card card{.flings = 100, .scenarios = 3};
  card.random.classes.same_bits = 100;
  for (const ClaimLine& claims :
       {ClaimLine{.changed = {{}}, .not_measured = {}}, ClaimLine{.changed = {}, .not_measured = {"a"}},
        ClaimLine{.changed = {}, .not_measured = {}, .other_numbers = 1}}) {
    card.claims = claims;
    EXPECT_EQ(consequence_of(card),
              "None in scenarios, flings, hard cases and random runs; claims of the paper change.");
  }
  EXPECT_FALSE(card.has_other_bits());
  EXPECT_TRUE(Card{.hard_cases = {.other_cases = 1}}.has_other_bits());
  card.hard_cases = {.cases = 144, .other_random_runs = {172, 500}};
  EXPECT_TRUE(card.has_other_bits());
  EXPECT_EQ(consequence_of(card),
            "None in scenarios and flings; 0 of 144 hard cases and 172 of 500 random runs differ.");
  card.hard_cases = {.cases = 144, .other_cases = 2, .other_random_runs = {172, 500}};
  EXPECT_EQ(consequence_of(card),
            "None in scenarios and flings; 2 of 144 hard cases and 172 of 500 random runs differ.");
  card.hard_cases.listing = {
      .cases = {0, 2}, .random_runs = {{0, 500}, {172, 500}}, .newly_broken = {"a: speed"}};
  EXPECT_TRUE(consequence_of(card).starts_with("None in scenarios and flings;"));
  card.hard_cases.general = {
      .cases = {0, 2}, .random_runs = {{0, 500}, {9, 500}}, .newly_broken = {"a: mirror"}};
  const std::string broken =
      "Invariants of any core break in 0 -> 2 of 144 hard cases and 0 -> 9 of 500 random runs.";
  EXPECT_EQ(consequence_of(card), broken);
  card.random.no_longer_settle = 3;
  EXPECT_EQ(consequence_of(card), "3 of 100 flings no longer settle within 20 s. " + broken);
}

}  // namespace
}  // namespace hyrax

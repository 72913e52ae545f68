// A card as a result: its lines, its JSON, its tables and figures.
#include <gtest/gtest.h>

#include "sim/card/card.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

// With no tables, and no points in its figures.
std::string text_of_same_bits(const Card& card) {
  const Result result = card_result(card);
  EXPECT_TRUE(result.tables.empty());
  for (const Figure& figure : result.figures)
    for (const Plot& plot : std::get<std::vector<Plot>>(figure.body))
      for (const Series& series : plot.series) EXPECT_TRUE(series.x.empty()) << figure.title;
  return described(result.verdict);
}

TEST(CardResult, IsTheOneApproved) {
  Card card;
  card.rest.moved_px = {std::vector(18, 0.0), std::vector(18, 0.0)};
  card.step.status = StepStatus::proved_equal;
  card.recordings = 1;
  card.exact_px = {{}};  // No fling stays finite.
  std::string text = "same bits\n" + text_of_same_bits(card);
  card.step = {.status = StepStatus::not_proved, .why = "a path is not known"};
  card.lacking = "the base has no GRAVITY";
  card.recordings = 0;
  card.exact_px.clear();
  text += "not measured\n" + text_of_same_bits(card);
  for (const Table& table : card_result(card).summary)
    if (table.name == "hard_cases" || table.name == "claims" || table.name == "recordings")
      text += described(table);
  card = {};
  card.flings = 1000;
  card.library.changed = {{"a.json",
                           {.has_same_bits = false,
                            .difference = DifferenceClass::contacts,
                            .contacts_before = 3,
                            .contacts_after = 2,
                            .largest = WorstDistance{.px = 6.0},
                            .end_shift_px = 5.0,
                            .no_longer_settles = true}}};
  ContactChanges& contacts = card.library.changed[0].change.contacts;
  contacts.moved.resize(2);
  contacts.only_a.resize(3);
  contacts.only_b.resize(4);
  card.hard_cases.general = {.newly_broken = {"one: finite"}, .mended = {"two: mirror"}};
  card.hard_cases.listing = {.newly_broken = {"three: speed"}, .mended = {"four: clamp"}};
  for (const char* const id : {"2.1-gravity", "two", "three", "four", "five", "six"})
    card.claims.changed.push_back({id, {"holds", "does not hold"}, {1200.0, 1250.0}, "px/s2"});
  card.recordings = 4;
  for (const auto& [path, px] : {std::pair("recorded/r.json", 2.0),
                                 {"recorded/s.json", 3.0},
                                 {"recorded/t.json", 4.0},
                                 {"recorded/still.json", 0.5}})
    card.library.changed.push_back({path, {.difference = DifferenceClass::values, .end_shift_px = px}});
  card.random.distances_px = {1.0, 2.0, 3.0, 4.0};
  card.displays = {.flings = 20, .spreads_px = {{5.0, 6.0}, {7.0}}};
  card.exact_px = {{Band{4, 2.0, 1.0, 3.0}, Band{4, 20.0, 10.0, 30.0}}};
  card.energy_px2_per_s2 = {{{Band{4, 120.0, 0.0, 240.0}, Band{4, 1320.0, 0.0, 2400.0}},
                             {Band{4, 1200.0, 0.0, 2400.0}, Band{4, 12000.0, 0.0, 24000.0}},
                             {Band{4, 12.0, 0.0, 24.0}, Band{4, -36.0, -48.0, 0.0}},
                             {Band{4, -2400.0, -3600.0, 0.0}, Band{4, -6000.0, -7200.0, 0.0}}}};
  card.seed = 7;
  card.scenarios = 2;
  card.step = {.status = StepStatus::changed, .why = "a path is not known"};
  card.step.changes = {{HeaderChangeKind::constant, "G 1 -> 2", 9, {"G", 1.0}, {"G", 2.0}}};
  for (std::int64_t line = 10; line < 17; ++line)
    card.step.changes.push_back({HeaderChangeKind::removed, "m_vx *= 2;", line, {}, {}});
  card.library.classes = {1, {2, 3, 4, 5}};
  card.library.cut = 6;
  card.contacts = {7, 8, 9, 10, {11, 12}};
  card.random.classes = {13, {14, 15, 16, 17}};
  card.random.changed_contacts = {18, 40};
  card.random.settled = {19, 20};
  card.random.no_longer_settle = 21;
  card.random.shift_px = Band{22, 23.0, 24.0, 25.0};
  card.random.distance_px = Band{26, 27.0, 28.0, 29.0};
  card.random.distance_max_px = 30.0;
  card.displays.spread_px.after = Band{31, 32.0, 33.0, 34.0};
  card.cost = {{{35, 36.0, 37.0, 38.0}, {39, 40.0, 41.0, 42.0}}, {43, 44.0, 45.0, 46.0}};
  card.hard_cases.cases = 47;
  card.hard_cases.other_cases = 48;
  card.hard_cases.other_random_runs = {49, 80};
  card.hard_cases.general.cases = {50, 51};
  card.hard_cases.general.random_runs = {{52, 80}, {53, 80}};
  card.hard_cases.listing.cases = {54, 55};
  card.claims.claims = 56;
  card.claims.not_measured = {"one", "two", "three", "four"};
  card.claims.other_numbers = 57;
  card.rest.moved_px = {std::vector(18, 0.5), std::vector(18, 0.25)};
  card.rest.moved_px.before[3] = 0.75;
  card.rest.moved_px.after[4] = 0.375;
  const Result result = card_result(card);
  text += described(result.verdict);
  for (const Table& table : result.summary) text += described(table);
  for (const Table& table : result.tables)  // The others are members of the summary.
    text += table.name == "invariants"
                ? described(table)
                : "table " + table.name + ": " + std::to_string(row_count(table)) + " rows\n";
  for (const Figure& figure : result.figures) text += described(figure);
  expect_approved("tests/unit/sim/card/card.txt", text);
}

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

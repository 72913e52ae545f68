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
  card.recordings = RecordingLine{};
  card.exact = {{1.0, {}}};  // No fling stays finite.
  std::string text = "same bits\n" + text_of_same_bits(card);
  card.step = {.status = StepStatus::not_proved, .why = "a path is not known"};
  card.lacking = "the base has no GRAVITY";
  card.recordings.reset();
  card.exact.clear();
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
  card.recordings =
      RecordingLine{.recordings = 4, .moved = {{"recorded/r.json", 2.0}, {"s.json", 3.0}, {"t.json", 4.0}}};
  card.random.distances_px = {1.0, 2.0, 3.0, 4.0};
  card.displays = {.flings = 20, .spreads_px = {{5.0, 6.0}, {7.0}}};
  card.exact = {{1.0, {Band{4, 2.0, 1.0, 3.0}, Band{4, 20.0, 10.0, 30.0}}}};
  card.energy = {.drift_px2_per_s2 = {Band{4, 120.0, 0.0, 240.0}, Band{4, 1320.0, 0.0, 2400.0}},
                 .lift_px2_per_s2 = {Band{4, 1200.0, 0.0, 2400.0}, Band{4, 12000.0, 0.0, 24000.0}},
                 .bounce_px2_per_s2 = {Band{4, 12.0, 0.0, 24.0}, Band{4, -36.0, -48.0, 0.0}},
                 .friction_px2_per_s2 = {Band{4, -2400.0, -3600.0, 0.0}, Band{4, -6000.0, -7200.0, 0.0}}};
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

}  // namespace
}  // namespace hyrax

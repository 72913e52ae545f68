// The tables and figures of a card, each value of which is another one.
#include <gtest/gtest.h>

#include "sim/card/card.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

TEST(CardResult, OfSameBitsHasNoTables) {
  Card card;
  card.recordings = RecordingLine{};
  EXPECT_TRUE(card_tables(card).empty());
  for (const Figure& figure : card_figures(card))
    for (const Plot& plot : std::get<std::vector<Plot>>(figure.body))
      for (const Series& series : plot.series) EXPECT_TRUE(series.x.empty()) << figure.title;
}

TEST(CardResult, IsTheOneApproved) {
  Card card;
  card.flings = 1000;
  card.library.changed = {{"a.json",
                           {.has_same_bits = false,
                            .difference = DifferenceClass::contacts,
                            .contacts_before = 3,
                            .contacts_after = 2,
                            .largest = WorstDistance{.px = 6.0},
                            .end_shift_px = 5.0}}};
  card.hard_cases.general = {.newly_broken = {"one: finite"}, .mended = {"two: mirror"}};
  card.hard_cases.listing = {.newly_broken = {"three: speed"}, .mended = {"four: clamp"}};
  card.claims.changed = {{"2.1-gravity", {"holds", "does not hold"}, {1200.0, 1250.0}, "px/s2"}};
  card.recordings = RecordingLine{.recordings = 1, .moved = {{"r.json", 2.0}}};
  card.random.distances_px = {1.0, 2.0, 3.0, 4.0};
  card.displays = {.flings = 20, .spreads_px = {{5.0, 6.0}, {7.0}}};
  card.exact = {{1.0, {Band{4, 2.0, 1.0, 3.0}, Band{4, 20.0, 10.0, 30.0}}}};
  card.energy = {.drift_px2_per_s2 = {Band{4, 120.0, 0.0, 240.0}, Band{4, 1320.0, 0.0, 2400.0}},
                 .lift_px2_per_s2 = {Band{4, 1200.0, 0.0, 2400.0}, Band{4, 12000.0, 0.0, 24000.0}},
                 .bounce_px2_per_s2 = {Band{4, 12.0, 0.0, 24.0}, Band{4, -36.0, -48.0, 0.0}},
                 .friction_px2_per_s2 = {Band{4, -2400.0, -3600.0, 0.0}, Band{4, -6000.0, -7200.0, 0.0}}};
  std::string text;
  for (const Table& table : card_tables(card)) text += described(table);
  for (const Figure& figure : card_figures(card)) text += described(figure);
  expect_approved("tests/unit/sim/card/card.txt", text);
}

}  // namespace
}  // namespace hyrax

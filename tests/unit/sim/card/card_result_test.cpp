#include "sim/card/card.h"

#include <array>

#include <gtest/gtest.h>

namespace hyrax {
namespace {

const Plot& plot_of(const Figure& figure) { return std::get<std::vector<Plot>>(figure.body).front(); }

TEST(CardResult, OfSameBitsHasNoTables) {
  Card card;
  card.recordings = RecordingLine{};
  EXPECT_TRUE(card_tables(card).empty());
  for (const Figure& figure : card_figures(card))
    for (const Series& series : plot_of(figure).series) EXPECT_TRUE(series.x.empty()) << figure.title;
}

TEST(CardResult, HasATableForEachKindOfDifference) {
  Card card;
  card.library.changed = {{"a.json",
                           {.has_same_bits = false,
                            .difference = DifferenceClass::contacts,
                            .contacts_before = 3,
                            .contacts_after = 2,
                            .end_shift_px = 5.0}}};
  card.hard_cases.general.mended = {"case: mirror"};
  card.hard_cases.listing.newly_broken = {"case: speed"};
  card.claims.changed = {{"2.1-gravity", {"holds", "does not hold"}, {1200.0, 1250.0}, "px/s2"}};
  card.recordings = RecordingLine{.recordings = 1, .moved = {{"r.json", 2.0}}};
  const std::vector<Table> tables = card_tables(card);
  ASSERT_EQ(tables.size(), 4u);
  EXPECT_EQ(row_count(tables[0]), 1u);
  EXPECT_EQ(std::get<std::vector<std::string>>(tables[0].columns[1].values).front(), "contacts");
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(tables[0].columns[4].values).front(), 3);
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(tables[0].columns[5].values).front(), 2);
  EXPECT_EQ(std::get<std::vector<std::string>>(tables[1].columns[1].values),
            (std::vector<std::string>{"general", "listing"}));
  EXPECT_EQ(std::get<std::vector<std::string>>(tables[1].columns[2].values),
            (std::vector<std::string>{"no longer broken", "newly broken"}));
  EXPECT_EQ(tables[2].name, "claims");
  EXPECT_EQ(std::get<std::vector<double>>(tables[3].columns[1].values).front(), 2.0);
}

TEST(CardResult, DrawsBothCores) {
  Card card;
  card.random.distances_px = {1.0, 2.0, 3.0, 4.0};
  card.displays.spreads_px = {{5.0, 6.0}, {7.0}};
  card.exact = {{1.0, {Band{4, 2.0, 1.0, 3.0}, Band{4, 20.0, 10.0, 30.0}}}};
  card.energy.lift_px2_per_s2 = {Band{4, 1200.0, 0.0, 2400.0}, Band{4, 12000.0, 0.0, 24000.0}};
  const std::vector<Figure> figures = card_figures(card);
  ASSERT_EQ(figures.size(), 4u);
  EXPECT_EQ(plot_of(figures[0]).series[0].y, (std::vector{25.0, 50.0, 75.0, 100.0}));
  EXPECT_EQ(plot_of(figures[1]).series[0].x, (std::vector{5.0, 6.0}));
  EXPECT_EQ(plot_of(figures[1]).series[1].x, (std::vector{7.0}));
  const std::vector<Series>& exact = plot_of(figures[2]).series;
  ASSERT_EQ(exact.size(), 6u);  // Low and high end, median.
  for (std::size_t each = 0; each < exact.size(); ++each) {
    EXPECT_EQ(exact[each].y, (std::vector{std::array{1.0, 3.0, 2.0, 10.0, 30.0, 20.0}[each]}));
    EXPECT_EQ(exact[each].look.dash, each % 3 == 2 ? Dash::solid : Dash::short_dashes);
  }
  const Series& change = plot_of(figures[3]).series[0];
  EXPECT_EQ(change.x, (std::vector{9.0}));  // px of height
  EXPECT_EQ(change.y, (std::vector{1.0}));
}

}  // namespace
}  // namespace hyrax

// What the members of a sweep have in common, and its pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/ensemble/member_numbers.h"

namespace hyrax {
namespace {

MemberNumbers numbers_of(const std::vector<double>& values, MemberRole role = MemberRole::result) {
  MemberNumbers numbers("x", "px", "left edge", role, static_cast<std::int64_t>(values.size()));
  for (const double value : values) numbers.add(value);
  return numbers;
}

// The values of a table's column.
const auto& column(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& each) { return each.name == name; });
  return found->values;
}

TEST(MemberNumbers, OfAWholeNumberAreWhole) {
  EXPECT_TRUE(numbers_of({3.0, std::nan(""), -1.0, 4.0}).is_whole());
  EXPECT_FALSE(numbers_of({0.5}).is_whole());
}

// Each column of a sample in which no two statistics are equal.
TEST(MemberTable, HasTheStatisticThatEachColumnNames) {
  const Table table = member_table({numbers_of({40.0, std::nan(""), 0.0, 10.0, 20.0, 130.0, std::nan("")})});
  const auto text = [&](const char* name) {
    return std::get<std::vector<std::string>>(column(table, name)).at(0);
  };
  const auto number = [&](const char* name) {
    return std::get<std::vector<double>>(column(table, name)).at(0);
  };
  EXPECT_EQ(text("number"), "x");
  EXPECT_EQ(text("unit"), "px");
  EXPECT_EQ(text("meaning"), "left edge");
  EXPECT_EQ(number("smallest"), 0.0);
  EXPECT_DOUBLE_EQ(number("p10"), 4.0);
  EXPECT_EQ(number("median"), 20.0);
  EXPECT_DOUBLE_EQ(number("p90"), 94.0);
  EXPECT_EQ(number("mean"), 40.0);
  EXPECT_EQ(number("largest"), 130.0);
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(column(table, "missing")).at(0), 2);
}

TEST(MemberNumbers, OfNoMemberAreNotGiven) {
  EXPECT_TRUE(std::isnan(numbers_of({std::nan("")}).smallest()));
  EXPECT_TRUE(std::isnan(numbers_of({}).mean()));
  EXPECT_TRUE(std::isnan(numbers_of({}).quantile(0.5)));
}

TEST(MemberNumbers, HaveASampleOfBoundedSizeThatMeetsEveryValueOfAGrid) {
  constexpr std::int64_t kMembers = 1'000'000, kGrid = 50;
  MemberNumbers numbers("x", "px", "", MemberRole::grid, kMembers);
  for (std::int64_t member = 0; member < kMembers; ++member) numbers.add(static_cast<double>(member % kGrid));
  EXPECT_LE(numbers.sample().size(), 20'000u);
  std::vector<int> met(kGrid);
  for (const double value : numbers.sample()) ++met[static_cast<std::size_t>(value)];
  EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
  EXPECT_EQ(sample_stride(kMembers, 20'000), 53);
  EXPECT_EQ(sample_stride(20'000, 20'000), 1);
}

TEST(MemberFigures, ShareAllMembersAmongTheIntervals) {
  std::vector<MemberNumbers> numbers;
  numbers.push_back(numbers_of({0.0, 1.0, 1.0, 2.0}));
  numbers.push_back(numbers_of({5.0, 6.0, 7.0, 8.0}, MemberRole::input));
  const std::vector<Figure> figures = member_figures(numbers, 4);
  ASSERT_EQ(figures.size(), 2u);
  const Series& shares = std::get<std::vector<Plot>>(figures[0].body)[0].series[0];
  EXPECT_EQ(shares.y, (std::vector<double>{25, 25, 50, 50, 25, 25}));
  EXPECT_EQ(shares.x.front(), -0.5);
  const Series& points = std::get<std::vector<Plot>>(figures[1].body)[0].series[0];
  EXPECT_EQ(points.x, (std::vector<double>{5, 6, 7, 8}));
  EXPECT_EQ(points.y, (std::vector<double>{0, 1, 1, 2}));
}

// Two grids of 5 x 2 fields, two members each; the median of a field is the number of the field and a half.
TEST(MemberFigures, MapEachResultOverTwoGrids) {
  std::vector<double> across, up, result;
  for (int member = 0; member < 20; ++member) {
    const int field = member / 2;
    across.push_back(field % 5);
    up.push_back(field / 5);
    result.push_back(field + member % 2);
  }
  const std::vector<MemberNumbers> numbers = {numbers_of(across, MemberRole::grid),
                                              numbers_of(up, MemberRole::grid), numbers_of(result)};
  const std::vector<Figure> figures = member_figures(numbers, 20);
  const Figure& map = figures.back();
  EXPECT_EQ(map.suffix, "-map-x");
  const Plot& plot = std::get<std::vector<Plot>>(map.body)[0];
  ASSERT_EQ(plot.series.size(), 5u);
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{0, 1}));
  EXPECT_EQ(plot.series[0].y, (std::vector<double>{0, 0}));
  EXPECT_EQ(plot.series[4].x, (std::vector<double>{3, 4}));
  EXPECT_EQ(plot.series[4].y, (std::vector<double>{1, 1}));
  std::size_t fields = 0;
  for (const Series& series : plot.series) fields += series.x.size();
  EXPECT_EQ(fields, 10u);
}

TEST(MemberTable, HasARowForEachNumber) {
  const Table table = member_table({numbers_of({1.0, 2.0}), numbers_of({3.0}, MemberRole::input)});
  EXPECT_EQ(row_count(table), 2u);
}

}  // namespace
}  // namespace hyrax

// What the members of a sweep have in common, and its pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/ensemble/member_numbers.h"
#include "tests/oracle/vectors.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

MemberNumbers numbers_of(const std::vector<double>& values, bool is_result = true,
                         const std::string& name = "x", const std::string& unit = "px") {
  MemberNumbers numbers(name, unit, "what " + name + " is", is_result,
                        static_cast<std::int64_t>(values.size()));
  for (const double value : values) numbers.add(value);
  for (const double value : values) numbers.bin(value);
  return numbers;
}

TEST(MemberNumbers, HaveASampleOfBoundedSizeThatMeetsEveryValueOfAGrid) {
  constexpr std::int64_t kMembers = 1'000'000, kGrid = 50;
  MemberNumbers numbers("x", "px", "", false, kMembers);
  for (std::int64_t member = 0; member < kMembers; ++member) numbers.add(static_cast<double>(member % kGrid));
  EXPECT_LE(numbers.sample().size(), 20'000u);
  std::vector<int> met(kGrid);
  for (const double value : numbers.sample()) ++met[static_cast<std::size_t>(value)];
  for (std::int64_t row = 0; row < std::ssize(numbers.sample()); ++row)  // A page counts on its members.
    ASSERT_EQ(numbers.sample()[static_cast<std::size_t>(row)], static_cast<double>(row * 51 % kGrid));
  EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
  EXPECT_EQ(sample_stride(kMembers), 51);
  EXPECT_EQ(sample_stride(100'000), 7);  // A grid of 5 or 10 values would lose some with 5.
  EXPECT_EQ(sample_stride(20'000), 1);
}

TEST(MemberFigures, CountAllMembersWhateverTheSampleIs) {
  std::vector<double> values(100'000);
  values[1] = 1.0;  // The sample holds every seventh.
  const Figure figure = member_figures({numbers_of(values)}, 100'000).front();
  EXPECT_EQ(figure.note, "all 100,000 members");
  const Series& bars = std::get<std::vector<Plot>>(figure.body).front().series.front();
  EXPECT_EQ(bars.y, (std::vector{99.999, 99.999, 0.001, 0.001}));
  EXPECT_EQ(member_figures({numbers_of(values)}, 200'000).front().note, "100,000 of 200,000 members");
}

TEST(MemberFigures, GiveWholeNumbersOfASmallRangeABarEach) {
  const struct {
    double smallest, largest, left;
    std::size_t bars, ticks;
  } cases[] = {{0.5, 11.0, 0.5, 40, 0},
               {0.0, 11.0, -0.5, 12, 12},
               {0.0, 12.0, -0.5, 13, 0},
               {0.0, 39.0, -0.5, 40, 0},
               {0.0, 40.0, 0.0, 40, 0}};
  for (const auto& [smallest, largest, left, bars, ticks] : cases) {
    const Plot plot = numbers_of({smallest, largest}).histogram();
    EXPECT_EQ(plot.series[0].x.size(), 2 * bars) << largest;
    EXPECT_EQ(plot.series[0].x[0], left) << largest;
    EXPECT_EQ(plot.x.ticks.size(), ticks) << largest;
  }
}

TEST(MemberFigures, LeaveOutWhatIsConstantButForRoundingOrHasNoWidth) {
  const std::vector<MemberNumbers> numbers = {numbers_of({1e-24, 0.0, -1e-24}), numbers_of({0.0, HUGE_VAL}),
                                              numbers_of({-1e308, 1e308}), numbers_of({0.0, 1e-6})};
  const std::vector<Figure> figures = member_figures(numbers, 3);
  EXPECT_EQ(figures.size(), 1u);
  EXPECT_EQ(std::get<std::vector<Plot>>(figures.at(0).body).size(), 1u);
}

// By numpy: tests/oracle/vectors.py.
TEST(MemberNumbers, HaveTheStatisticsOfASecondProgram) {
  for (const Json& entry : vectors("statistics")) {
    const std::vector<double> values = exact_list(entry, "values"), parts = exact_list(entry, "parts"),
                              quantiles = exact_list(entry, "quantiles");
    const MemberNumbers numbers = numbers_of(values);
    for (std::size_t each = 0; each < parts.size(); ++each)
      EXPECT_NEAR(numbers.quantile(parts[each]), quantiles[each], 1e-9);
    const Table table = member_table({numbers});
    for (const auto& [name, value] : {std::pair("smallest", quantiles[0]),
                                      {"p10", quantiles[1]},
                                      {"median", quantiles[3]},
                                      {"mean", exact(entry, "mean")},
                                      {"p90", quantiles[5]},
                                      {"largest", quantiles[6]}}) {
      const auto column = std::ranges::find(table.columns, name, &Column::name);
      ASSERT_NE(column, table.columns.end()) << name;
      EXPECT_NEAR(std::get<std::vector<double>>(column->values).front(), value, 1e-9) << name;
    }
    const Figure figure = member_figures({numbers}, std::ssize(values)).front();
    const Series& bars = std::get<std::vector<Plot>>(figure.body).front().series.front();
    const Json::Array& counts = *entry.find("counts")->get<Json::Array>();
    ASSERT_EQ(bars.y.size(), 2 * counts.size());
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
      EXPECT_NEAR(bars.y[2 * bin], 100.0 * counts[bin].number() / static_cast<double>(values.size()), 1e-9);
  }
}

// Two grids of 6 x 2 fields, two members each, an input, and results: real, whole, with members that have
// none, of none.
TEST(MemberNumbers, GiveTheApprovedTableAndFigures) {
  std::vector<double> across, up, speed, place, contacts, rest;
  for (int member = 0; member < 24; ++member) {
    const int field = member / 2;
    across.push_back(field % 6);
    up.push_back(10 * (field / 6));
    speed.push_back(100.0 + 7 * member % 40);
    place.push_back(0.5 + field * field + member % 2);
    contacts.push_back(member % 5);
    rest.push_back(member % 4 == 0 ? std::nan("") : 2.0 + 0.1 * member);
  }
  const std::vector<MemberNumbers> numbers = {numbers_of(place),
                                              numbers_of(contacts, true, "contacts.left", "1"),
                                              numbers_of(rest, true, "at_rest_since", "s"),
                                              numbers_of(speed, true, "vx", "px/s"),
                                              numbers_of(std::vector(24, std::nan("")), true, "y"),
                                              numbers_of(across, false, "start.x_px"),
                                              numbers_of(up, false, "clock.rate_hz", "Hz"),
                                              numbers_of(speed, false, "start.vx_px_per_s", "px/s")};
  std::string text = described(member_table(numbers));
  for (const Figure& figure : member_figures(numbers, 24)) text += described(figure);
  expect_approved("tests/unit/sim/ensemble/members.txt", text);
}

}  // namespace
}  // namespace hyrax

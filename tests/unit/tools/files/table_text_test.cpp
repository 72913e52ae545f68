#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/files/table_text.h"

namespace hyrax {
namespace {

const double kMissing = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(CsvText, HasHeadsWithUnitsShortestNumbersAndQuotesWhereTheyMustBe) {
  const Table table{
      "t",
      "",
      {{"speed", "px/s", "", std::vector<double>{0.1, kMissing, kInfinity, -2.0}},
       {"energy", "px2/s2", "", std::vector<double>{1.0, 2.0, 3.0, 4.0}},
       {"order", "1", "", std::vector<std::int64_t>{-7, 0, 1'000'000'000'000, 1}},
       {"method", "", "", std::vector<std::string>{"plain", "a, b", "the \"step\"", "two\nlines"}}}};
  EXPECT_EQ(csv_text(table),
            "speed_px_per_s,energy_px2_per_s2,order,method\n0.1,1,-7,plain\n,2,0,\"a, b\"\n"
            "inf,3,1000000000000,\"the \"\"step\"\"\"\n-2,4,1,\"two\nlines\"\n");
}

Table two_rates() {
  return {"rates",
          "",
          {{"method", "", "", std::vector<std::string>{"paper", "größer"}},
           {"rate", "Hz", "", std::vector<double>{60.0, 144.0}},
           {"path_length", "px", "", std::vector<double>{3214.04, kMissing}, 5},
           {"contacts", "1", "", std::vector<std::int64_t>{3, 12}},
           {"agrees", "", "", std::vector<bool>{true, false}}}};
}

TEST(AlignedText, NumbersAreAtTheRightUnderNamesWithUnits) {
  EXPECT_EQ(aligned_text(two_rates()),
            "  method  rate, Hz  path length, px  contacts  agrees\n"
            "  paper         60           3214.0         3    true\n"
            "  größer       144                -        12   false\n");
  EXPECT_EQ(aligned_text({"t", "", {{"rate", "Hz", "", std::vector<double>{}}}}), "  rate, Hz\n");
}

TEST(AlignedText, ValuesOfVeryDifferentSizeEachHaveTheirDigits) {
  const Table table{"t", "", {{"error", "px", "", std::vector<double>{1.23456e-9, 0.5, 0.0, kInfinity}, 3}}};
  EXPECT_EQ(aligned_text(table), "  error, px\n   1.23e-09\n        0.5\n          0\n   no bound\n");
}

TEST(AlignedText, ValuesOfOneColumnCanEachHaveTheirDigits) {
  Table table{"t", "", {{"error", "px", "", std::vector{17.35, 0.2614, 0.0, HUGE_VAL, std::nan("")}, 3}}};
  EXPECT_EQ(aligned_text(table),
            "  error, px\n       17.4\n        0.3\n        0.0\n   no bound\n          -\n");
  table.columns[0].is_each_rounded = true;
  EXPECT_EQ(aligned_text(table),
            "  error, px\n       17.4\n      0.261\n          0\n   no bound\n          -\n");
}

std::string json_text(const Table& table) { return to_text(json_of(table)); }

TEST(JsonOfTable, RowsAreObjectsAndAMissingNumberIsNull) {
  EXPECT_EQ(
      json_text(two_rates()),
      R"([{ "method": "paper", "rate_hz": 60, "path_length_px": 3214.04, "contacts": 3, "agrees": true }, )"
      R"({ "method": "größer", "rate_hz": 144, "path_length_px": null, "contacts": 12, "agrees": false }])");
}

TEST(JsonOfTable, HasTheShapeThatIsAskedFor) {
  Table table = two_rates();
  table.shape = JsonShape::values;
  EXPECT_EQ(json_text(table), R"(["paper", "größer"])");
  table.columns.resize(2);
  table.shape = JsonShape::by_first;
  EXPECT_EQ(json_text(table), R"({ "paper": { "rate_hz": 60 }, "größer": { "rate_hz": 144 } })");
  table.shape = JsonShape::one;
  EXPECT_EQ(json_text(table), R"({ "method": "paper", "rate_hz": 60 })");
  table.columns = {{"rate", "Hz", "", std::vector<double>{}}};
  EXPECT_EQ(json_text(table), "null");
}

TEST(JsonOfTable, ACellMayHoldATable) {
  const Table inner{"inner", "", {{"n", "1", "", std::vector<std::int64_t>{7}}}};
  const Table table{"t", "", {{"parts", "", "", std::vector<Table>{inner}}}};
  EXPECT_EQ(json_text(table), R"([{ "parts": [{ "n": 7 }] }])");
}

struct Throw {
  double speed_px_per_s = 0.0;
  std::optional<double> landing_px;
  std::optional<std::int64_t> row;
  std::uint8_t wall = 0;
};

constexpr std::string_view kWalls[] = {"left", "right", "top"};
constexpr ColumnOf<Throw> kColumns[] = {
    {"speed", "px/s", "", &Throw::speed_px_per_s},
    {"landing", "px", "", &Throw::landing_px, "where/x"},
    {"row", "", "", &Throw::row, "where/row"},
    {"wall", "", "", ColumnOf<Throw>::Code{[](const Throw& each) { return each.wall; }, {kWalls, true}}},
    {"speed_rel", "1", "", [](const Throw& each) { return each.speed_px_per_s / 2000.0; }, "-"},
};

TEST(AlignedText, UnitsHaveALineOfTheirOwnWhereOnlyThatFits) {
  Table table;
  for (int column = 0; column < 12; ++column)
    table.columns.push_back({"error", "px", "", std::vector<double>{1.5}});
  const std::string text = aligned_text(table);
  EXPECT_EQ(text.find("  error  error"), 0u) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  table.columns.resize(9);
  EXPECT_EQ(aligned_text(table).find("  error, px  error, px"), 0u);
}

TEST(TableOfRecords, HasNamesOfCodesMembersOfObjectsAndOnlyWhatHasAKey) {
  const Table table{.columns =
                        columns_of(kColumns, std::vector<Throw>{{1000.0, 2.5, 7, 4}, {500.0, {}, {}, 1}})};
  EXPECT_EQ(json_text(table),
            R"([{ "speed_px_per_s": 1000, "where": { "x": 2.5, "row": 7 }, "wall": "top" }, )"
            R"({ "speed_px_per_s": 500, "where": { "x": null, "row": null }, "wall": "left" }])");
  EXPECT_EQ(csv_text(table),
            "speed_px_per_s,landing_px,row,wall,speed_rel\n1000,2.5,7,top,0.5\n500,,,left,0.25\n");
}

TEST(AddMembers, MembersJoinTheObjectAndOthersAreNamed) {
  Json::Object object;
  add_members(object, {{"", "", {{"within", "px", "", std::vector<double>{1.0}}}, JsonShape::members},
                       {"rates", "", {{"rate", "Hz", "", std::vector<double>{60.0}}}}});
  EXPECT_EQ(to_text(Json(object)), R"({ "within_px": 1, "rates": [{ "rate_hz": 60 }] })");
}

}  // namespace
}  // namespace hyrax

#include "tools/files/table_text.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

Table two_rates(JsonForm form) {
  return {"rates",
          "",
          {{"method", "", "", std::vector<std::string>{"paper", "größer"}},
           {"rate", "Hz", "", std::vector<double>{60.0, 144.0}},
           {"path_length", "px", "", std::vector<double>{3214.04, kNotGiven}, 5},
           {"contacts", "1", "", std::vector<std::int64_t>{3, 12}},
           {"agrees", "", "", std::vector<bool>{true, false}}},
          form};
}

Table column_of(const Column& column, std::size_t count = 1) {
  return {"t", "", std::vector<Column>(count, column), JsonForm::one};
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

// Aligned, comma-separated, and as JSON.
TEST(TableText, OfTablesIsTheOneApproved) {
  const Column errors{"error", "px", "", std::vector{17.35, 0.2614, 0.0, HUGE_VAL, kNotGiven}, 3};
  Column rounded = errors, of_all_sizes = errors;
  rounded.is_each_rounded = true;
  of_all_sizes.values = std::vector{1.23456e-9, 0.5, 0.0, -HUGE_VAL};
  const Column energy{"energy", "px2/s2", "", std::vector{1.5}};
  const std::vector<Throw> throws = {{1000.0, 2.5, 7, 4}, {500.0, {}, {}, 1}};
  std::string text;
  for (const Table& table :
       {two_rates(JsonForm::rows), two_rates(JsonForm::values), two_rates(JsonForm::by_first),
        two_rates(JsonForm::one), column_of(errors, 9), column_of(errors, 10), column_of(rounded),
        column_of(of_all_sizes), column_of({"no_rows", "Hz", "", std::vector<double>{}}),
        column_of({"large", "1", "", std::vector<std::int64_t>{-7, 1'000'000'000'000}}),
        Table{.columns = {{"huge", "px", "", std::vector{1e9}, 4, false, "one/x"},
                          {"tiny", "px", "", std::vector{5e-7}, 4, false, "two/x"}}},
        column_of({"text", "", "", std::vector<std::string>{"a, b", "the \"step\"", "two\nlines"}}),
        Table{.columns = columns_of(kColumns, throws)}})
    text += aligned_text(table) + csv_text(table) + to_text(json_of(table)) + "\n\n";
  for (const std::size_t width : {1U, 20U, 40U})
    text += aligned_text({.columns = columns_of(kColumns, throws)}, width) + "\n";
  const Table parts = column_of({"parts", "", "", std::vector{two_rates(JsonForm::rows)}});
  Json::Object members;
  add_members(members, {two_rates(JsonForm::rows), {"", "", {energy}, JsonForm::members}});
  expect_approved("tests/unit/tools/files/tables.txt",
                  text + to_text(json_of(parts)) + "\n" + to_text(Json(members)) + "\n");
}

}  // namespace
}  // namespace hyrax

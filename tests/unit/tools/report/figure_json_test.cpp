// Figures, tables and verdicts as the report page reads them.
#include <gtest/gtest.h>

#include <regex>

#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/files/refusal.h"
#include "tools/files/temporary_folder.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_json.h"
#include "tools/report/page_file.h"
#include "tools/report/result_page.h"

namespace hyrax {
namespace {

TEST(FigureJson, RefusesWhatIsNoFigureAndSaysWhere) {
  const auto refused = [](const std::string& text) {
    return refusal_of([&] { static_cast<void>(figures_of(parse_json(text, "text"), "figures")); });
  };
  EXPECT_EQ(
      refused(R"([{"title": "t", "new": 1, "body": {"plots": [{"series": [{"x": [1], "y": [null]}]}]}}])"),
      "");
  EXPECT_EQ(refused(R"([{"title": 3}])"), "figures/0/title: must be a text");
  EXPECT_EQ(refused(R"([{}, {"body": {"plots": [{"x": 3}]}}])"),
            "figures/1/body/plots/0/x: must be an object");
  EXPECT_EQ(refused(R"([{"note_tone": "pink"}])"), "figures/0/note_tone: unknown name (found \"pink\")");
  for (const char* const row : {"-1", "null", "1000001"})
    EXPECT_EQ(refused(R"([{"body": {"cells": [{"row": )" + std::string(row) + "}]}}]"),
              "figures/0/body/cells/0/row: must be a count");
  for (const char* const low : {"true", R"("far")"})
    EXPECT_EQ(refused(R"([{"body": {"plots": [{"x": {"low": )" + std::string(low) + "}}]}}]"),
              "figures/0/body/plots/0/x/low: must be a number or null");
  for (const char* const series :
       {R"({"x": [1], "y": []})", R"({"x": [1], "y": [1], "look": {"form": "band"}})",
        R"({"x": [1], "y": [1], "y_low": [1, 2]})", R"({"x": [1], "y": [1], "x_low": [1]})",
        R"({"x": [1], "y": [1], "x_low": [1, 2], "x_high": [1, 2]})",
        R"({"x": [1], "y": [1], "point_names": ["a", "b"]})"})
    EXPECT_EQ(refused(R"([{"body": {"plots": [{"series": [)" + std::string(series) + "]}]}}]"),
              "figures/0/body/plots/0/series/0: its lists must have equal lengths");
  EXPECT_EQ(refused(R"([{"body": {"list_columns": [{}], "list_rows": [[]]}}])"),
            "figures/0/body: list_rows: each needs all columns");
}

// Whole numbers are exact in a page; of a table there are all rows, of one in JSON the first.
TEST(ResultPage, OfTwoResultsIsTheOneApproved) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  const Table table{"t",
                    "some table",
                    {{"n", "px", "a count", std::vector<std::int64_t>{kExact, -kExact - 1, 3}, 3},
                     {"x", "", "", std::vector<double>{0.5, kNotGiven, 1.0}},
                     {"is", "", "", std::vector<bool>{true, false, true}},
                     {"at", "", "", std::vector<std::optional<std::int64_t>>{{}, kExact + 1, 2}},
                     {"word", "", "", std::vector<std::string>{"a", "b", "c"}}}};
  const ShownResult bad{.title = "<b> & more",
                        .subtitle = "what it is",
                        .judgement = "a rule is broken",
                        .verdict = {.text = {"first", table, "last"}, .broken = {"one <rule>", "another"}},
                        .tables = {table},
                        .figures = {{.title = "figure & <co>", .subtitle = "<of> it"}},
                        .origin = {{"core", "paper"}, {"built_by", "g++"}}};
  const Json good = result_json({.title = "good"});
  EXPECT_FALSE(has_members(good));
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/page.html";
  write_result_page(path, "report a.h5", {result_json(bad), good});
  std::string page = read_text_file(path);
  write_result_page(path, "report b.h5", {Json::Object{{"title", "swept"}, {"sweep", Json::Object{}}}});
  page += "\n" + read_text_file(path);
  expect_approved("tests/unit/tools/report/pictures/results.txt",
                  std::regex_replace(page, std::regex("hyrax-sim [0-9.]+"), "hyrax-sim VERSION"));
  const Json first = table_json(table, 2);
  EXPECT_EQ(first.find("row_count")->number(), 3.0);
  for (const Json& column : *first.find("columns")->get<Json::Array>())
    EXPECT_EQ(column.find("values")->get<Json::Array>()->size(), 2u);
}

}  // namespace

// Replaces the page templates, which an everyday build lacks.
std::string_view page_template(PageKind kind) {
  switch (kind) {
    case PageKind::runs:
      return "runs";
    case PageKind::results:
      return "results\n<!--without JavaScript-->\n{\"hyrax\":\"report data\"}";
    case PageKind::sweeps:
      return "sweeps\n<!--without JavaScript-->\n{\"hyrax\":\"report data\"}";
  }
  return {};
}

}  // namespace hyrax

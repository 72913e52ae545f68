// Figures, tables and verdicts as the report page reads them.
#include <gtest/gtest.h>

#include <regex>

#include "tests/unit/tools/files/refusal.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_json.h"

namespace hyrax {
namespace {

std::string compact(const Json& json) {
  std::string text = to_text(json);
  std::erase(text, ' ');
  return text;
}

TEST(FigureJson, NamesTonesAndFormsAndLeavesMissingNumbersOut) {
  Plot plot{.x = {.label = "dt, s", .is_logarithmic = true}};
  plot.series = {{.name = "a",
                  .look = {.form = Form::bars, .tone = Tone::sky_blue},
                  .x = {1.5, kNotGiven},
                  .y = {0.0, 2.0}}};
  plot.marks = {{.at = 3.0, .text = "mark", .tone = Tone::none}};
  const std::string text = compact(figure_json({.title = "T", .body = std::vector{plot}}));
  for (const char* const part :
       {R"("title":"T")", R"("form":"bars","tone":"sky_blue")", R"("x":[1.5,null])", R"("low":null)",
        R"("is_logarithmic":true)", R"("text":"mark","tone":"none")"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
}

TEST(FigureJson, NamesTheColoursOfWallsAsThePageDoes) {
  const std::string page = read_text_file(std::string(HYRAX_SOURCE_DIR) + "/tools/report/page/painter.js");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      page, found,
      std::regex("wallColors = \\{ 1: '([-a-z]+)', 2: '([-a-z]+)', 4: '([-a-z]+)', 8: '([-a-z]+)' \\};")));
  for (std::size_t wall = 0; wall < kWallTones.size(); ++wall) {
    std::string tone = found[wall + 1].str();
    std::replace(tone.begin(), tone.end(), '-', '_');
    Plot plot;
    plot.marks = {{.at = 0.0, .text = "", .tone = kWallTones[wall]}};
    EXPECT_NE(compact(figure_json({.body = std::vector{plot}})).find(R"("tone":")" + tone + '"'),
              std::string::npos)
        << tone;
  }
}

TEST(FigureJson, HoldsGridsAndLists) {
  const Grid grid{.rows = {"r"},
                  .columns = {{"c", Tone::ink}},
                  .cells = {{.tone = Tone::good, .text = "1", .right = 0.5}}};
  EXPECT_NE(compact(figure_json({.body = grid})).find(R"("tone":"good","text":"1","left":0,"right":0.5)"),
            std::string::npos)
      << compact(figure_json({.body = grid}));
  const Listing listing{.columns = {{.title = "t"}}, .rows = {{{.text = "x", .fill = Tone::bad}}}};
  EXPECT_NE(compact(figure_json({.body = listing})).find(R"("text":"x","detail":"","fill":"bad")"),
            std::string::npos);
}

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
  EXPECT_EQ(refused(R"([{"body": {"cells": [{"row": -1}]}}])"),
            "figures/0/body/cells/0/row: must be a count");
  for (const char* const series :
       {R"({"x": [1], "y": []})", R"({"x": [1], "y": [1], "look": {"form": "band"}})",
        R"({"x": [1], "y": [1], "x_low": [1]})", R"({"x": [1], "y": [1], "point_names": ["a", "b"]})"})
    EXPECT_EQ(refused(R"([{"body": {"plots": [{"series": [)" + std::string(series) + "]}]}}]"),
              "figures/0/body/plots/0/series/0: its lists must have equal lengths");
  EXPECT_EQ(refused(R"([{"body": {"list_columns": [{}], "list_rows": [[]]}}])"),
            "figures/0/body: list_rows: each needs all columns");
}

TEST(TableJson, HasTheFirstRowsAndCountsAll) {
  const Table table{
      .name = "t",
      .columns = {{.name = "n", .values = std::vector<std::int64_t>{1, (std::int64_t{1} << 53) + 1, 3}},
                  {.name = "x", .values = std::vector<double>{0.5, kNotGiven, 1.0}}}};
  const std::string text = compact(table_json(table, 2));
  EXPECT_NE(text.find(R"("row_count":3)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("values":[1,"9007199254740993"])"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("values":[0.5,null])"), std::string::npos) << text;
}

TEST(VerdictJson, KeepsSentencesAndTablesInOrder) {
  const Verdict verdict{.text = {"first", Table{.name = "t"}, "last"}, .broken = {"a rule"}};
  const Json json = verdict_json(verdict);
  const auto& text = *json.find("text")->get<Json::Array>();
  ASSERT_EQ(text.size(), 3u);
  EXPECT_NE(text[1].find("row_count"), nullptr);
  EXPECT_EQ(*text[2].get<std::string>(), "last");
}

}  // namespace
}  // namespace hyrax

// Pictures, compared with approved ones to the last line of their SVG; figures, tables and verdicts as the
// report page reads them.
#include <gtest/gtest.h>

#include <regex>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/temporary_folder.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_json.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"
#include "tools/report/result_page.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

void expect_picture(const std::string& name, const std::string& svg) {
  EXPECT_EQ(picture_faults(svg), std::vector<std::string>{}) << name;
  expect_approved("tests/unit/tools/report/pictures/" + name, svg);
}

// The JSON files are the figures. `stacked` has plots below each other with all that a plot may have, texts
// that meet and that have no room; the widest ticks are those of the second. `beside` has bars with their
// texts, points of equal scales in both directions, ticks that were chosen, a line without a text, which
// takes no room, and a series whose name begins that of another. In `grid` a row's name is above its fields
// on a narrow sheet. Long texts are broken there.
TEST(Pictures, OfFiguresAreThoseApproved) {
  for (const std::string name : {"stacked", "beside", "grid", "list"}) {
    const std::string path = "tests/unit/tools/report/pictures/" + name + ".json";
    const std::string json = read_text_file(HYRAX_SOURCE_DIR "/" + path);
    const Figure figure = figures_of(parse_json(json, path), name).at(0);
    expect_approved(path, to_text(Json::Array{figure_json(figure)}, 5) + "\n");
    expect_picture(name + ".svg", figure_svg(figure));
    expect_picture(name + ".html", figure_html(figure));
  }
}

// Of which rows were not recorded.
TEST(Pictures, OfARunIsTheOneApproved) {
  const Scenario scenario =
      load_scenario(HYRAX_SOURCE_DIR "/tests/unit/tools/report/pictures/thrown-twice.json");
  RunRecorder recorder(step_count(scenario));
  static_cast<void>(replay(shipped_core(), scenario, recorder));
  const StoredRun run = recorder.take();
  Columns rows;
  for (std::size_t row = 0; row < run.rows.size(); ++row)
    if (row < 60 || row > 75) rows.append(run.rows.row(row));
  expect_picture("run.svg", run_svg(scenario, rows, run.contacts));
}

TEST(FigureJson, RefusesWhatIsNoFigureAndSaysWhere) {
  const std::string path = HYRAX_SOURCE_DIR "/tests/unit/tools/report/refused_figures.json";
  const Json table = parse_json(read_text_file(path), path);
  for (const auto& [refusal, refused] : *table.get<Json::Object>())
    for (const Json& figures : *refused.get<Json::Array>())
      EXPECT_EQ(refusal_of([&] { static_cast<void>(figures_of(figures, "figures")); }), refusal)
          << to_text(figures);
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

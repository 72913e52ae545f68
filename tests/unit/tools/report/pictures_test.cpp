// Pictures, compared with approved ones to the last line of their SVG.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_json.h"
#include "tools/report/figure_svg.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

void expect_picture(const std::string& name, const std::string& svg) {
  EXPECT_EQ(picture_faults(svg), std::vector<std::string>{}) << name;
  expect_approved("tests/unit/tools/report/pictures/" + name, svg);
}

// The JSON files are the figures: `stacked` has plots below each other with all that a plot may have, the
// widest ticks being those of the second. `beside` has bars with their texts, points of equal scales in both
// directions, and ticks that were chosen. In `grid` a row's name is above its fields on a narrow sheet.
TEST(Pictures, OfFiguresAreThoseApproved) {
  for (const std::string name : {"stacked", "beside", "grid", "list"}) {
    const std::string path = "tests/unit/tools/report/pictures/" + name + ".json";
    const std::string json = read_text_file(HYRAX_SOURCE_DIR "/" + path);
    const Figure figure = figures_of(parse_json(json, path), name).at(0);
    expect_approved(path, to_text(Json::Array{figure_json(figure)}, 5) + "\n");
    expect_picture(name + ".svg", figure_svg(figure));
    if (name != "stacked") expect_picture(name + ".html", figure_html(figure));
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

}  // namespace
}  // namespace hyrax

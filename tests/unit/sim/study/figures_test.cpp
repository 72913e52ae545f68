// The pictures of every study, as data.
#include <gtest/gtest.h>

#include "sim/study/study.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/study/clocks.h"

namespace hyrax {
namespace {

StudyResult quick(const Study& study) {
  StudyRequest request{.is_quick = true, .machine = "some machine", .now_ns = steady_ns};
  if (study.takes_scenarios) {
    request.scenarios = {{"mine.json", fling_at(60.0, 300)}};
    request.scenarios[0].scenario.name = "mine";
  }
  return study.run(request);
}

void expect_drawable(const Series& series) {
  EXPECT_EQ(series.x.size(), series.y.size());
  if (series.look.form == Form::band) {
    EXPECT_EQ(series.y_low.size(), series.x.size());
  }
  EXPECT_EQ(series.x_low.size(), series.x_high.size());
  if (!series.x_low.empty()) {
    EXPECT_EQ(series.x_low.size(), series.x.size());
  }
}

void expect_drawable(const Grid& grid) {
  EXPECT_FALSE(grid.cells.empty());
  for (const Cell& cell : grid.cells) {
    EXPECT_LT(cell.row, grid.rows.size());
    EXPECT_LT(cell.column, grid.columns.size());
    EXPECT_LT(cell.left, cell.right);
  }
}

void expect_drawable(const Listing& listing) {
  EXPECT_FALSE(listing.rows.empty());
  for (const auto& row : listing.rows) EXPECT_EQ(row.size(), listing.columns.size());
}

void expect_drawable(const std::vector<Plot>& plots) {
  EXPECT_FALSE(plots.empty());
  for (const Plot& plot : plots) {
    EXPECT_FALSE(plot.series.empty());
    EXPECT_FALSE(plot.x.label.empty());
    for (const Series& series : plot.series) {
      SCOPED_TRACE(series.name);
      expect_drawable(series);
    }
  }
}

TEST(Figures, OfEveryStudyHaveTheirNumbers) {
  for (const Study& study : studies())
    for (const Figure& figure : quick(study).figures) {
      SCOPED_TRACE(study.name + ": " + figure.title);
      EXPECT_FALSE(figure.title.empty());
      std::visit([](const auto& body) { expect_drawable(body); }, figure.body);
    }
}

}  // namespace
}  // namespace hyrax

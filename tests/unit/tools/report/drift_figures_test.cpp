#include "tools/report/drift_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tools/report/drift_figures.h"
#include "tools/report/plot_frame.h"
#include "tools/report/run_plot.h"

namespace hyrax {
namespace {

// Arcs of ten rows each, that end at the ground.
struct MeasuredRun {
  Scenario scenario;
  DriftSummary summary;
  std::vector<ArcErrors> arcs;
  std::vector<ImpactErrors> contacts;
  std::vector<DrawnRow> rows;

  explicit MeasuredRun(std::size_t count) {
    scenario.name = "some-fling";
    for (std::size_t arc = 0; arc < count; ++arc) {
      const auto first = static_cast<std::int64_t>(10 * arc);
      arcs.push_back({.first_step = first,
                      .last_step = first + 9,
                      .ended_by = ArcEnd::ground,
                      .energy_largest_px2_per_s2 = 1e6});
      contacts.push_back({.step = first + 10, .effective_restitution = 0.59});
      for (std::int64_t row = 0; row < 10; ++row) {
        const auto n = static_cast<double>(row);
        rows.push_back({arc,
                        {.step = first + row,
                         .t_s = static_cast<double>(first + row) / 60.0,
                         .implementation_px = 1e-13 * n,
                         .truncation_px = 0.1 * n,
                         .model_px = 0.2 * n,
                         .energy_px2_per_s2 = 1e6,
                         .energy_drift_px2_per_s2 = -1e3 * n}});
      }
      summary.effective_restitution.add(0.59);
    }
    summary.arcs = summary.contacts = static_cast<std::int64_t>(count);
  }
  [[nodiscard]] DriftPicture picture() const { return {scenario, 10.0, summary, arcs, contacts, rows}; }
};

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(PowerOfTen, IsWrittenAsPeopleDo) {
  EXPECT_EQ(power_of_ten(6), "10⁶");
  EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
  EXPECT_EQ(power_of_ten(0), "10⁰");
}

TEST(EnergyFigure, ShowsRunAndReferenceInReadableUnits) {
  const MeasuredRun run(2);
  const std::string script = energy_figure_script(run.picture());
  EXPECT_TRUE(has(script, "specific energy, 10⁶ px²/s²"));
  EXPECT_TRUE(has(script, "0.15 1 0.991\n"));  // t, exact, run of the arc's last row.
}

TEST(EnergyFigure, MarksEveryOtherArcAndTheWallsThatEndThem) {
  const MeasuredRun run(3);
  const std::string script = energy_figure_script(run.picture());
  EXPECT_TRUE(
      has(script, "rectangle from first 0.1666666667, graph 0 to first 0.3166666667, graph 1 behind"));
  EXPECT_EQ(count_of(script, "graph 1.035 point"), 3u);
}

TEST(EnergyFigure, MarksNoMoreArcsThanCanBeToldApart) {
  const MeasuredRun run(500);
  EXPECT_EQ(count_of(energy_figure_script(run.picture()), "graph 1.035 point"), 0u);
}

TEST(EnergyDriftFigure, IsInPercentOfTheArcsEnergyAndBreaksBetweenArcs) {
  const MeasuredRun run(2);
  const std::string script = energy_drift_figure_script(run.picture());
  EXPECT_TRUE(has(script, "0.15 -0.9\n\n0.166666667 -0\n"));
}

// Of the energy of a pixel of height, where the arc has less.
TEST(EnergyDriftFigure, IsInPercentOfAPixelOfHeightAtLeast) {
  MeasuredRun run(1);
  run.arcs[0].energy_largest_px2_per_s2 = -5.0;
  EXPECT_TRUE(has(energy_drift_figure_script(run.picture()), "0.15 -750\n"));
}

TEST(ErrorsFigure, HasATicForEveryOtherDecadeAndNoLogarithmOfZero) {
  const MeasuredRun run(1);
  const std::string script = errors_figure_script(run.picture());
  EXPECT_TRUE(has(script, "set yrange [1e-14:1e2]"));
  EXPECT_TRUE(has(script, "'10⁻¹⁴' 1e-14, '10⁻¹²' 1e-12"));
  EXPECT_TRUE(has(script, "0 NaN NaN NaN\n"));
}

TEST(ErrorsFigure, NoErrorHasTheColourOfAWall) {
  const MeasuredRun run(2);
  const std::string script = errors_figure_script(run.picture());
  const std::string plotted = script.substr(script.rfind("plot "));
  for (const Wall wall : kWalls) EXPECT_FALSE(has(plotted, std::string(wall_colour(wall))));
}

TEST(RestitutionFigure, DrawsThePapersValueAndSaysTheMean) {
  const MeasuredRun run(4);
  const std::string script = restitution_figure_script(run.picture());
  EXPECT_TRUE(has(script, "from graph 0, first 0.6 to graph 1, first 0.6"));
  EXPECT_TRUE(has(script, "mean 0.590, spread 0.000"));
  EXPECT_TRUE(has(script, "4 0.59\n"));
}

TEST(RestitutionFigure, LeavesOutWhatWasPutToRest) {
  MeasuredRun run(2);
  run.contacts[1].effective_restitution = 0.0;
  EXPECT_FALSE(has(restitution_figure_script(run.picture()), "\n2 0\n"));
}

TEST(DriftFigures, SayWhereThereIsNothingToShow) {
  const MeasuredRun run(0);
  EXPECT_TRUE(has(energy_figure_script(run.picture()), "no flight of two steps or more"));
  EXPECT_TRUE(has(energy_drift_figure_script(run.picture()), "no flight of two steps or more"));
  EXPECT_TRUE(has(errors_figure_script(run.picture()), "no flight of two steps or more"));
  EXPECT_TRUE(has(restitution_figure_script(run.picture()), "no contact that ends a flight"));
}

}  // namespace
}  // namespace hyrax

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/unit/sim/replay/some_flings.h"
#include "tools/report/drift_figures.h"

namespace hyrax {
namespace {

// Arcs of ten rows each, that end at the ground.
struct MeasuredRun : DriftRun {
  explicit MeasuredRun(std::size_t count) {
    for (std::size_t arc = 0; arc < count; ++arc) {
      const auto first = static_cast<std::int64_t>(10 * arc);
      arcs.push_back({.first_step = first,
                      .last_step = first + 9,
                      .ended_by = ArcEnd::ground,
                      .energy_scale_px2_per_s2 = 1e6});
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
};

const Plot& plot_of(const Figure& figure) { return std::get<std::vector<Plot>>(figure.body).front(); }

Figure energy_of(const MeasuredRun& run) { return drift_figures(run)[1]; }
Figure errors_of(const MeasuredRun& run) { return drift_figures(run)[2]; }
Figure restitution_of(const MeasuredRun& run) { return drift_figures(run)[3]; }

TEST(DriftFigures, MarkNoMoreThanReadersCanDistinguishAndSaySo) {
  EXPECT_EQ(plot_of(energy_of(MeasuredRun(80))).top_dots.size(), 80u);
  EXPECT_TRUE(plot_of(energy_of(MeasuredRun(81))).top_dots.empty());
  MeasuredRun run(2);
  run.summary.arcs = 7;
  EXPECT_EQ(energy_of(run).note, "the first 2 of 7 arcs");
  run.scenario = fling_at(60.0, 100, {13, {std::int64_t{5}, Stop{}}});
  EXPECT_EQ(plot_of(energy_of(run)).marks.size(), 12u);
  run.scenario = fling_at(
      60.0, 100, {{std::int64_t{5}, Stop{}}, {std::int64_t{6}, Place{}}, {std::int64_t{90}, Stop{}}});
  EXPECT_EQ(plot_of(energy_of(run)).marks.size(), 1u)
      << "not a hand's way, nor what comes after the last flight";
  run.arcs.pop_back();
  EXPECT_EQ(plot_of(energy_of(run)).series[0].x.size(), 10u) << "of the arcs that are kept";
  EXPECT_EQ(plot_of(restitution_of(MeasuredRun(20))).x.ticks.back().text, "20");
  EXPECT_TRUE(plot_of(restitution_of(MeasuredRun(21))).x.ticks.empty());
  run.contacts[1].effective_restitution = 0.0;
  EXPECT_EQ(plot_of(restitution_of(run)).series[0].x, std::vector<double>{1.0}) << "not what was put to rest";
}

TEST(EnergyFigure, HasOneToThreeDigitsBeforeThePointAndIsLogarithmicUnlessEnergyIsNegative) {
  MeasuredRun run(1);
  for (const auto& [most, unit, shown] : {std::tuple(999.0, "px²/s²", 999.0),
                                          {1000.0, "10³ px²/s²", 1.0},
                                          {999'999.0, "10³ px²/s²", 999.999},
                                          {1e6, "10⁶ px²/s²", 1.0}}) {
    for (DrawnRow& row : run.rows)
      row.errors.energy_px2_per_s2 = most, row.errors.energy_drift_px2_per_s2 = 0.0;
    const Plot plot = plot_of(energy_of(run));
    EXPECT_EQ(plot.y.label, std::string("specific energy, ") + unit);
    for (const Series& series : plot.series) EXPECT_DOUBLE_EQ(series.y.front(), shown);
    EXPECT_TRUE(plot.y.is_logarithmic);
  }
  run.rows[3].errors.energy_px2_per_s2 = -1.0;
  EXPECT_FALSE(plot_of(energy_of(run)).y.is_logarithmic);
}

TEST(ErrorsFigure, HasAStripForRoundingAndNoLogarithmOfZero) {
  MeasuredRun run(1);
  const Plot plot = plot_of(errors_of(run));
  EXPECT_DOUBLE_EQ(plot.y.strip_below, 2.0 * 9e-13);
  for (const Series& series : plot.series) EXPECT_TRUE(std::isnan(series.y.front()));
  for (DrawnRow& row : run.rows) row.errors.implementation_px *= 1e9;
  EXPECT_TRUE(std::isnan(plot_of(errors_of(run)).y.strip_below)) << "more than rounding";
}

}  // namespace
}  // namespace hyrax

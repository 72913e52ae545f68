// Two runs in one picture.
#include "sim/compare/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "sim/result/number_text.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

Row row_at(std::int64_t step, double x_px, double y_px) {
  return {.step = step, .t_s = 0.5 * static_cast<double>(step), .x_px = x_px, .y_px = y_px};
}

std::vector<Plot> plots_of(const Overlay& overlay) {
  return std::get<std::vector<Plot>>(overlay.figure({"title", "subtitle", "a", "b", {20, 10}, {2, 2}}).body);
}

TEST(Overlay, IsThePictureApproved) {
  Overlay overlay;
  for (std::int64_t step = 0; step < 5; ++step) {
    const double x_px = 1.0 + static_cast<double>(step * step);
    overlay.add(row_at(step, x_px, 2.0), row_at(step, step < 2 ? x_px : x_px + 3.0, step < 3 ? 2.0 : 6.0));
  }
  expect_approved("tests/unit/sim/compare/overlay.txt",
                  described(overlay.figure({"the title", "the subtitle", "a.h5", "b.h5", {34, 22}, {4, 2}})));
}

TEST(Overlay, HasNoAxisOfDistancesThatAreAllZero) {
  Overlay overlay;
  overlay.add(row_at(0, 1.0, 2.0), row_at(0, 1.0, 2.0));
  const std::vector<Plot> plots = plots_of(overlay);
  EXPECT_TRUE(plots[1].series[0].x.empty());
  EXPECT_EQ(plots[1].when_empty, "the same place at every time");
  EXPECT_EQ(plots[0].series.size(), 5u);  // Walls, paths, start and end.
}

TEST(Overlay, DrawsDistancesOnALogarithmicAxisWithALineForZero) {
  Overlay overlay;
  for (const double px : {0.0, 1e-6, 1e-9, 700.0}) overlay.add(row_at(0, 0.0, 2.0), row_at(0, px, 2.0));
  const Axis axis = plots_of(overlay)[2].y;
  EXPECT_TRUE(axis.is_logarithmic);
  EXPECT_DOUBLE_EQ(axis.zero_at, 1e-10);
}

// Of a sprite of 2 px in a window of 20 x 10: corners of both where they are close, both whole where they are
// not.
TEST(Overlay, MagnifiesBothSpritesWhereTheyAreFarthestAndRulesTheDistance) {
  for (const auto& [px, half, whole] : {std::tuple(1e-9, 1e-9, 0.0), {0.4, 0.4, 0.0}, {6.0, 2.2, 1.0}}) {
    Overlay overlay;
    overlay.add(row_at(0, 1.0, 2.0), row_at(0, 1.0, 2.0));
    overlay.add(row_at(1, 1.0, 2.0), row_at(1, 1.0 + px, 2.0));
    overlay.add(row_at(2, 1.0, 2.0), row_at(2, 1.0 + px / 2, 2.0));
    const Plot plot = plots_of(overlay)[1];
    const double away = (1.0 + px) - 1.0;
    ASSERT_EQ(plot.series.size(), 3u);
    EXPECT_EQ(plot.series[0].x, (std::vector<double>{0, 2, 2, 0, 0}));
    EXPECT_EQ(plot.series[1].x, (std::vector<double>{away, away + 2, away + 2, away, away}));
    EXPECT_EQ(plot.series[2].x, (std::vector<double>{0.0, away}));
    EXPECT_TRUE(plot.y.label.starts_with("farthest, at 0.5 s: ")) << plot.y.label;
    EXPECT_EQ(plot.texts[0].text, rounded(away, 3) + " px");
    EXPECT_NEAR((plot.y.high - plot.y.low) / 2, half, 1e-6 * half);
    EXPECT_NEAR((plot.y.high + plot.y.low) / 2, whole, 1e-9);
    EXPECT_NEAR((plot.x.high + plot.x.low) / 2, away / 2 + whole, 1e-9);
    EXPECT_NEAR((plot.x.high - plot.x.low) / (plot.y.high - plot.y.low), 2.0, 1e-6)
        << "as wide as the window";
  }
}

TEST(Overlay, LeavesOutWhatIsNotFinite) {
  Overlay overlay;
  overlay.add(row_at(0, 1.0, 2.0), row_at(0, std::numeric_limits<double>::quiet_NaN(), 2.0));
  overlay.add(row_at(1, std::numeric_limits<double>::infinity(), 2.0), row_at(1, 1.0, 2.0));
  const Plot over_time = plots_of(overlay)[1];
  EXPECT_TRUE(over_time.series[0].y.empty());
  EXPECT_EQ(over_time.when_empty, "no row is finite in both");
}

// However long the run is, the row of the largest distance is drawn.
TEST(Overlay, KeepsTheLargestDistanceOfALongRun) {
  for (const std::int64_t farthest : {0, 1, 12'345, 99'999, 100'001}) {
    Overlay overlay;
    for (std::int64_t step = 0; step < 100'002; ++step)
      overlay.add(row_at(step, 0.0, 0.0), row_at(step, step == farthest ? 7.0 : 1.0, 0.0));
    const Series distance = plots_of(overlay)[2].series[0];
    EXPECT_LE(distance.y.size(), Overlay::kPairsMax);
    EXPECT_GT(distance.y.size(), Overlay::kPairsMax / 4);
    EXPECT_EQ(std::ranges::max(distance.y), 7.0) << farthest;
    for (std::size_t pair = 1; pair < distance.x.size(); ++pair) {
      EXPECT_GE(distance.x[pair], distance.x[pair - 1]);
      EXPECT_LE(distance.x[pair], distance.x[pair - 1] + 0.5 * 100'002 / (Overlay::kPairsMax / 8.0));
    }
  }
}

}  // namespace
}  // namespace hyrax

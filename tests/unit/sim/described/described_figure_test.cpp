// The picture of a run as data: paths, values by unit, marks, thinning.
#include <gtest/gtest.h>

#include <array>

#include "sim/described/described_figure.h"
#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

struct Glider {
  double x = 0.0, y = 5.0, speed = 60.0, width = 300.0, height = 200.0;
  int count = 0;
  bool is_far = false;

  void step(double dt_s) {
    x += speed * dt_s;
    is_far = x > 30.0;
    ++count;
  }
  template <class See>
  void state(See&& see) {
    see("kite.x_px", x);
    see("kite.y_px", y);
    see("speed_px_per_s", speed);
    see("count", count);
  }
  template <class See>
  void inputs(See&& see) {
    see("width_px", width);
    see("height_px", height);
  }
  template <class See>
  void actions(See&& see) {
    see("turn", [&] { speed = -speed; });
  }
  template <class See>
  void contacts(See&& see) const {
    see("far", is_far);
  }
  template <class See>
  void outputs(See&& see) const {
    see("twice_px_per_s", 2.0 * speed);
  }
};

/// REQUIRES: the scenario outlives the picture.
template <class Core>
DescribedPicture drawn(const DescribedScenario& scenario) {
  static const DescribedCore core = core_for_test<Core>();
  DescribedPicture picture(core.description, scenario);
  DescribedSink* const sink = &picture;
  static_cast<void>(play(core, scenario, {&sink, 1}));
  return picture;
}

std::vector<Plot> plots_of(const DescribedPicture& picture, const DescribedPicture* golden = nullptr) {
  return std::get<std::vector<Plot>>(picture.figure("", golden).body);
}

std::vector<Plot> plots_of_glider(std::int64_t steps, std::vector<DescribedEvent> events) {
  DescribedScenario scenario = scenario_for_test(steps);
  scenario.inputs = {{0, word_of(400.0)}};
  scenario.events = std::move(events);
  return plots_of(drawn<Glider>(scenario));
}

TEST(DescribedPicture, OfRowsThatAFileHasOfMoreSaysHowManyAndMarksEventsAtTheNext) {
  struct Recorded : DescribedSink {
    DescribedPicture picture;
    Recorded(const DescribedCore& core, const DescribedScenario& scenario)
        : picture(core.description, scenario) {}
    void row(const DescribedRow& row) override {
      if (row.step % 7 == 0) picture.row(row);
    }
  };
  const DescribedCore core = core_for_test<Glider>();
  DescribedScenario scenario = scenario_for_test(60);
  scenario.events = {event_for_test(45, Act{0, {}})};
  Recorded recorded(core, scenario);
  DescribedSink* const sink = &recorded;
  static_cast<void>(play(core, scenario, {&sink, 1}));
  EXPECT_EQ(recorded.picture.rows().long_name, "One row of every 7");
  const Figure figure = recorded.picture.figure("");
  EXPECT_TRUE(figure.legend.empty()) << "in which row a contact begins is not known";
  const auto plots = std::get<std::vector<Plot>>(figure.body);
  ASSERT_EQ(plots.back().marks.size(), 1u);
  EXPECT_NEAR(plots.back().marks[0].at, 49.0 / 60.0, 1e-9);
}

TEST(DescribedPicture, HasAPathInItsFrameValuesByUnitAndMarks) {
  const std::vector<Plot> plots = plots_of_glider(
      60, {event_for_test(45, Act{0, {}}), event_for_test(50, SetValues{{}, {{1, word_of(6.0)}}})});
  ASSERT_EQ(plots.size(), 3u);  // The path, values without a unit, speeds.
  const Plot& path = plots[0];
  ASSERT_EQ(path.series.size(), 3u);
  EXPECT_EQ(path.series[0].x, (std::vector{0.0, 400.0, 400.0, 0.0, 0.0}));
  EXPECT_EQ(path.series[0].y, (std::vector{0.0, 0.0, 200.0, 200.0, 0.0}));
  EXPECT_EQ(path.series[1].name, "kite");
  ASSERT_EQ(path.series[1].x.size(), 61u);
  EXPECT_EQ(path.series[1].x[30], 30.0 / 60.0 * 60.0);
  EXPECT_EQ(path.series[1].y[51], 6.0);
  ASSERT_EQ(path.series[2].x.size(), 1u) << "a contact once, at its first row";
  EXPECT_GT(path.series[2].x[0], 30.0);
  EXPECT_EQ(plots[1].series[0].name, "count");
  EXPECT_EQ(plots[1].series[0].y[60], 60.0);
  EXPECT_EQ(plots[2].y.label, "px/s");
  ASSERT_EQ(plots[2].series.size(), 2u);
  EXPECT_EQ(plots[2].series[1].name, "twice_px_per_s");
  EXPECT_EQ(plots[2].series[1].y[60], -120.0);
  ASSERT_EQ(plots[2].marks.size(), 2u);
  EXPECT_EQ(plots[2].marks[0].text, "turn");
  EXPECT_NEAR(plots[2].marks[0].at, 46.0 / 60.0, 1e-9);
  EXPECT_EQ(plots[2].marks[1].text, "set");
}

struct Moody {
  double x = 0.0, y = 0.0;
  int mood = 0, pose = 0, laps = 0;
  void step(double dt_s) { x += 60.0 * dt_s, mood = x > 3.0 ? 1 : 0, ++laps; }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("y_px", y);
    see("mood", mood, {"calm", "wild"});
    see("laps", laps);
    see("pose", pose, {"sit", "fly"});
  }
};

TEST(DescribedPicture, NamesValuesAtItsAxesAndInItsTable) {
  const DescribedScenario scenario = scenario_for_test(6);
  const DescribedPicture picture = drawn<Moody>(scenario);
  const std::vector<Plot> plots = plots_of(picture);
  ASSERT_EQ(plots.size(), 4u);  // The path, laps, and a plot for each list of names.
  EXPECT_EQ(plots[1].y.label, "laps");
  EXPECT_TRUE(plots[1].y.ticks.empty());
  EXPECT_EQ(plots[2].y.label, "mood");
  ASSERT_EQ(plots[2].y.ticks.size(), 2u);
  EXPECT_EQ(plots[2].y.ticks[1].text, "wild");
  const Table rows = picture.rows();
  EXPECT_EQ(std::get<std::vector<std::string>>(rows.columns[4].values),
            (std::vector<std::string>{"calm", "calm", "calm", "calm", "wild", "wild", "wild"}));
}

TEST(DescribedPicture, DrawsTheGoldenRunBehindIfItHasTheSameValues) {
  const DescribedScenario scenario = scenario_for_test(6), longer = scenario_for_test(8);
  const DescribedPicture now = drawn<Moody>(scenario), golden = drawn<Moody>(longer),
                         of_other = drawn<Glider>(longer);
  const std::vector<Plot> plots = plots_of(now, &golden);
  ASSERT_EQ(plots[0].series.size(), 2u);
  EXPECT_EQ(plots[0].series[0].name, "position, golden");
  EXPECT_EQ(plots[0].series[0].x.size(), 9u);
  EXPECT_EQ(plots[0].series[1].x.size(), 7u);
  EXPECT_EQ(plots[1].series[0].name, "laps, golden");
  EXPECT_EQ(now.figure("", &golden).legend.back().text, "golden file");
  EXPECT_EQ(plots_of(now, &of_other)[0].series.size(), 1u);
  EXPECT_TRUE(now.figure("", &of_other).legend.empty());
}

struct Marbles {
  double x = 0.0, y = 0.0, other_x = 50.0, other_y = 0.0;
  int count = 0;
  void step(double /*dt_s*/) { ++count; }
  template <class See>
  void state(See&& see) {
    see("a.x_px", x);
    see("a.y_px", y);
    see("b.x_px", other_x);
    see("b.y_px", other_y);
    see("count", count);
  }
  template <class See>
  void contacts(See&& see) const {
    see("a_floor", count == 1);
    see("a_b", count == 3);
    see("click", count == 5);
  }
};

TEST(DescribedPicture, AContactIsDrawnOnThePathsThatItsNameHas) {
  const DescribedScenario scenario = scenario_for_test(6);
  const Plot path = plots_of(drawn<Marbles>(scenario)).front();
  ASSERT_EQ(path.series.size(), 4u);  // Both paths, each with its contacts.
  EXPECT_EQ(path.series[1].x.size(), 3u) << "a_floor, a_b, and click, which names none";
  EXPECT_EQ(path.series[3].x, (std::vector{50.0, 50.0}));
}

template <std::size_t kBalls>
struct Balls {
  std::array<double, kBalls> x = {}, y = {}, spin = {};
  void step(double /*dt_s*/) {}
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("y_px", y);
    see("spin", spin);
  }
};
template <std::size_t kBalls>
std::size_t remarks() {
  const DescribedScenario scenario = scenario_for_test(1);
  return drawn<Balls<kBalls>>(scenario).figure("").remarks.size();
}

TEST(DescribedPicture, SaysOnceThatNotAllValuesAreDrawn) {
  EXPECT_EQ(remarks<12>(), 0u);
  EXPECT_EQ(remarks<13>(), 1u);
}

TEST(DescribedPicture, OfALongRunHasRowsAtEvenDistances) {
  const std::vector<Plot> plots = plots_of_glider(30'000, {});
  const std::vector<double>& t_s = plots[1].series[0].x;
  EXPECT_LE(t_s.size(), DescribedPicture::kPointsMax);
  EXPECT_GT(t_s.size(), DescribedPicture::kPointsMax / 3);
  EXPECT_NEAR(t_s[1] - t_s[0], t_s.back() - t_s[t_s.size() - 2], 1e-9);
  EXPECT_GT(t_s.back(), 499.0);
}

}  // namespace
}  // namespace hyrax

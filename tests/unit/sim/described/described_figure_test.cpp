// The picture of a run as data: paths, values by unit, marks, thinning.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "sim/described/described_figure.h"
#include "tests/unit/sim/described/core_for_test.h"
#include "tests/unit/sim/result/described.h"

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
  void state(auto&& see) {
    see("kite.x_px", x);
    see("kite.y_px", y);
    see("speed_px_per_s", speed);
    see("count", count);
  }
  void inputs(auto&& see) {
    see("width_px", width);
    see("height_px", height);
  }
  void actions(auto&& see) {
    see("turn", [&] { speed = -speed; });
  }
  void contacts(auto&& see) const { see("far", is_far); }
  void outputs(auto&& see) const { see("twice_px_per_s", 2.0 * speed); }
};

/// REQUIRES: the scenario outlives the picture.
template <class Core>
std::unique_ptr<DescribedPicture> drawn(const DescribedScenario& scenario) {
  static const DescribedCore core = core_for_test<Core>();
  auto picture = std::make_unique<DescribedPicture>(core.description, scenario);
  DescribedSink* const sink = picture.get();
  static_cast<void>(play(core, scenario, {&sink, 1}));
  return picture;
}

// Of rows that a file has of more.
struct EverySeventhRow : DescribedSink {
  DescribedPicture picture;
  EverySeventhRow(const DescribedCore& core, const DescribedScenario& scenario)
      : picture(core.description, scenario) {}
  void row(const DescribedRow& row) override {
    if (row.step % 7 == 0) picture.row(row);
  }
};

struct Moody {
  double x = 0.0, y = 0.0;
  int mood = 0, pose = 0, laps = 0;
  void step(double dt_s) { x += 60.0 * dt_s, mood = x > 3.0 ? 1 : 0, ++laps; }
  void state(auto&& see) {
    see("x_px", x);
    see("y_px", y);
    see("mood", mood, {"calm", "wild"});
    see("laps", laps);
    see("pose", pose, {"sit", "fly"});
  }
};

struct Marbles {
  double x = 0.0, y = 0.0, other_x = 50.0, other_y = 0.0;
  int count = 0;
  void step(double /*dt_s*/) { ++count; }
  void state(auto&& see) {
    see("a.x_px", x);
    see("a.y_px", y);
    see("b.x_px", other_x);
    see("b.y_px", other_y);
    see("count", count);
  }
  void contacts(auto&& see) const {
    see("a_floor", count == 1);
    see("a_b", count == 3);
    see("click", count == 5);
  }
};

template <std::size_t kBalls>
struct Balls {
  std::array<double, kBalls> x = {}, y = {}, spin = {};
  void step(double /*dt_s*/) {}
  void state(auto&& see) {
    see("x_px", x);
    see("y_px", y);
    see("spin", spin);
  }
};

// A path in its frame, values by unit and names, marks; contacts on the paths that their names have; a golden
// run behind, if it has the same values; twelve paths, and a remark on more.
TEST(DescribedPicture, OfRunsAreThoseApproved) {
  DescribedScenario turned = scenario_for_test(60);
  turned.inputs = {{0, word_of(400.0)}};
  turned.events = {event_for_test(45, Act{0, {}}), event_for_test(50, SetValues{{}, {{1, word_of(6.0)}}})};
  const DescribedScenario some = scenario_for_test(6), longer = scenario_for_test(8);
  const auto moody = drawn<Moody>(some), golden = drawn<Moody>(longer);
  const auto of_other = drawn<Glider>(longer);
  const DescribedCore glider = core_for_test<Glider>();
  EverySeventhRow few(glider, turned);
  DescribedSink* const sink = &few;
  static_cast<void>(play(glider, turned, {&sink, 1}));
  std::string text;
  const auto add = [&text](const std::string& what, const DescribedPicture& picture,
                           const DescribedPicture* behind = nullptr) {
    text += what + "\n" + described(picture.figure("found", behind));
  };
  add("a path, a turn and a set", *drawn<Glider>(turned));
  add("the same of every seventh row", few.picture);
  text += described(few.picture.rows());
  add("names of values", *moody);
  text += described(moody->rows());
  add("before its golden run", *moody, golden.get());
  add("before a run of other values", *moody, of_other.get());
  add("contacts of paths", *drawn<Marbles>(some));
  add("12 paths", *drawn<Balls<12>>(some));
  add("13 paths", *drawn<Balls<13>>(some));
  expect_approved("tests/unit/sim/described/pictures.txt", text);
}

TEST(DescribedPicture, OfALongRunHasRowsAtEvenDistances) {
  const DescribedScenario scenario = scenario_for_test(30'000);
  const auto plots = std::get<std::vector<Plot>>(drawn<Glider>(scenario)->figure("").body);
  const std::vector<double>& t_s = plots[1].series[0].x;
  EXPECT_LE(t_s.size(), DescribedPicture::kPointsMax);
  EXPECT_GT(t_s.size(), DescribedPicture::kPointsMax / 3);
  EXPECT_NEAR(t_s[1] - t_s[0], t_s.back() - t_s[t_s.size() - 2], 1e-9);
  EXPECT_GT(t_s.back(), 499.0);
}

}  // namespace
}  // namespace hyrax

#include "sim/reference/arc_cutter.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/sim/reference/test_run.h"

namespace hyrax {
namespace {

struct SeenArc {
  ArcStart start;
  std::int64_t last_step = 0;
  ArcEnd ended_by = ArcEnd::end;
  std::optional<std::int64_t> clamped_step;
};

struct Seen : ArcVisitor {
  void begin(const ArcStart& start) override { open = {start, start.row.step, ArcEnd::end, std::nullopt}; }
  void fly(const Row& row) override {
    EXPECT_EQ(row.step, open.last_step + 1);
    EXPECT_EQ(row.contact, 0);
    open.last_step = row.step;
  }
  void end(ArcEnd ended_by, const Row* clamped) override {
    open.ended_by = ended_by;
    if (clamped != nullptr) open.clamped_step = clamped->step;
    arcs.push_back(open);
  }
  void short_arc(const ArcStart& start, const Row* flown, const Row* clamped) override {
    ASSERT_TRUE(flown != nullptr || clamped != nullptr);
    const std::int64_t flown_steps = flown != nullptr ? 1 : 0;
    EXPECT_TRUE(flown == nullptr || flown->step == start.row.step + 1);
    EXPECT_TRUE(clamped == nullptr || clamped->step == start.row.step + flown_steps + 1);
  }
  SeenArc open;
  std::vector<SeenArc> arcs;
};

struct Cut {
  std::vector<SeenArc> arcs;
  std::int64_t skipped_arcs = 0;
  std::optional<std::int64_t> non_finite_step;
};

Cut cut(const Scenario& scenario, const Columns& rows) {
  Seen seen;
  ArcCutter cutter(scenario, inputs_of(scenario), seen);
  cutter.rows(rows);
  cutter.finish();
  return {seen.arcs, cutter.skipped_arcs(), cutter.non_finite_step()};
}

Cut cut(const Scenario& scenario) { return cut(scenario, rows_of(scenario)); }

// Flies, one event at frame 10, flies on.
Scenario interrupted_by(const Action& action) {
  Scenario scenario = open_sky({300.0, -500.0}, 60.0, 30);
  scenario.events.push_back({std::int64_t{10}, action});
  return scenario;
}

TEST(ArcCutter, NamesTheWallInXInACorner) {
  Columns rows = fly_by(paper_step(0.999), open_sky({300.0, -500.0}, 60.0, 5));
  rows.contact.back() = static_cast<std::uint8_t>(Wall::right) | static_cast<std::uint8_t>(Wall::ground);
  EXPECT_EQ(cut(open_sky({}, 60.0, 5), rows).arcs.at(0).ended_by, ArcEnd::right);
}

TEST(ArcCutter, BeginsAnArcAfterTheInputsOfTheNextFrame) {
  Scenario scenario = interrupted_by(Fling{{-100.0, -900.0}});
  scenario.events.push_back({std::int64_t{10}, Place{{7000.0, 8000.0}}});
  scenario.events.push_back({std::int64_t{10}, Hitch{0.5}});  // No input, but the last event.
  const Row start = cut(scenario).arcs.at(1).start.row;
  EXPECT_EQ(start.vx_px_per_s, -100.0);
  EXPECT_EQ(start.vy_px_per_s, -900.0);
  EXPECT_EQ(start.x_px, 7000.0);
  EXPECT_EQ(start.y_px, 8000.0);
}

TEST(ArcCutter, FollowsTheSizesInForce) {
  const Cut c = cut(interrupted_by(Resize{Size{900'000, 800'000}, std::nullopt}));
  ASSERT_EQ(c.arcs.size(), 2u);
  EXPECT_EQ(c.arcs[0].start.bounds.right_px, 1'000'000.0 - 128.0);
  EXPECT_EQ(c.arcs[1].start.bounds.right_px, 900'000.0 - 128.0);
  EXPECT_EQ(c.arcs[1].start.bounds.bottom_px, 800'000.0 - 128.0);
}

TEST(ArcCutter, ReportsAnInputOnTheRowBeforeAClamp) {
  Scenario scenario = fling();
  const std::int64_t clamped_step = cut(scenario).arcs.at(0).clamped_step.value();
  scenario.events.push_back({clamped_step - 1, Resize{Size{1921, 1080}, std::nullopt}});
  const Cut c = cut(scenario);
  EXPECT_EQ(c.arcs.at(0).ended_by, ArcEnd::input);
  EXPECT_EQ(c.skipped_arcs - cut(fling()).skipped_arcs, 1);  // The frame between the input and the clamp.
}

TEST(ArcCutter, SkipsArcsOfFewerThanTwoSteps) {
  const struct {
    std::int64_t steps;
    std::vector<std::int64_t> stops;
    std::size_t arcs;
    std::int64_t skipped_arcs;
  } cases[] = {{12, {1, 3, 11}, 2, 2},  // One step before the first stop, then two, and one after the last.
               {30, {0}, 1, 0},         // It is the start that is stopped.
               {0, {}, 0, 0}};
  for (const auto& [steps, stops, arcs, skipped_arcs] : cases) {
    Scenario scenario = open_sky({300.0, -500.0}, 60.0, steps);
    for (const std::int64_t frame : stops) scenario.events.push_back({frame, Stop{}});
    const Cut c = cut(scenario);
    ASSERT_EQ(c.arcs.size(), arcs) << steps;
    EXPECT_EQ(c.skipped_arcs, skipped_arcs) << steps;
    EXPECT_TRUE(arcs != 1 || c.arcs[0].start.row.vx_px_per_s == 0.0);
  }
}

TEST(ArcCutter, StopsBeforeARowThatIsNotFiniteOrThatNoScenarioHas) {
  for (const auto& [column, value] :
       {std::pair(&Columns::vy_px_per_s, std::numeric_limits<double>::quiet_NaN()),
        {&Columns::x_px, -2e100},
        {&Columns::dt_s, -1e-9},
        {&Columns::dt_s, 2e9}}) {
    Columns rows = fly_by(paper_step(0.999), open_sky({300.0, -500.0}, 60.0, 30));
    (rows.*column)[20] = value;
    const Cut c = cut(open_sky({}, 60.0, 30), rows);
    ASSERT_EQ(c.arcs.size(), 1u);
    EXPECT_EQ(c.arcs[0].last_step, 19);
    EXPECT_EQ(c.non_finite_step, 20);
  }
}

}  // namespace
}  // namespace hyrax

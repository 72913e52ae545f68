// Runs of described cores, each held to a loop of its own.
#include <gtest/gtest.h>
#include <bit>
#include <limits>

#include "tests/unit/sim/described/core_for_test.h"

namespace hyrax {
namespace {

// A ball on a floor, pushed by an input.
struct Bouncer {
  double y = 0.0;
  double vy = 0.0;
  double push = 0.0;
  double gravity = 100.0;
  bool floor = false;
  int order = 0;  // Digits of what was set, in order.

  void step(double dt_s) {
    vy += (gravity + push) * dt_s;
    y += vy * dt_s;
    floor = y > 10.0;
    if (floor) y = 10.0, vy = -vy;
  }
  void state(auto&& see) {
    see("y_px", y);
    see("vy_px_per_s", vy);
    see(
        "order", [&] { return order; }, [&](int given) { order = order * 10 + given; });
  }
  void inputs(auto&& see) {
    see("push", push);
    see(
        "input_order", [&] { return order; }, [&](int given) { order = order * 10 + given; });
  }
  void parameters(auto&& see) {
    see("gravity", gravity);
    see(
        "parameter_order", [&] { return order; }, [&](int given) { order = order * 10 + given; });
  }
  void actions(auto&& see) {
    see("kick", [&](double speed) { vy = speed; }, {"speed_px_per_s"});
  }
  void contacts(auto&& see) const { see("floor", floor); }
  void outputs(auto&& see) const { see("height_px", 10.0 - y); }
  void properties(auto&& see) const {
    see.always("above the floor", y <= 10.0);
    see.sometimes("fast", vy > 40.0);
    see.always("never up", vy >= 0.0);
  }
};

TEST(DescribedRun, APlainLoopHasItsRowsContactsAndProperties) {
  DescribedScenario scenario = scenario_for_test(200);
  scenario.start = {{0, word_of(3.0)}};
  scenario.parameters = {{0, word_of(80.0)}};
  scenario.events = {event_for_test(50, SetValues{{{0, word_of(5.0)}}, {{1, word_of(-20.0)}}}),
                     event_for_test(60, Hitch{0.25}),
                     event_for_test(70, Act{0, {word_of(33.0)}}),
                     event_for_test(80, Hold{}),
                     event_for_test(85, Act{0, {word_of(-44.0)}}),
                     event_for_test(90, Go{})};
  RowsForTest rows;
  const DescribedSummary summary = play_for_test(core_for_test<Bouncer>(), scenario, rows);

  Bouncer expected;
  expected.y = 3.0;
  expected.gravity = 80.0;
  ASSERT_EQ(rows.rows.size(), 201U);
  std::int64_t contacts = 0;
  std::optional<std::int64_t> up;
  for (std::int64_t row = 0; row <= 200; ++row) {
    double dt_s = row == 0 ? 0.0 : 1.0 / 60.0;
    bool is_held = false;
    const bool was_on_floor = row > 0 && rows.rows[static_cast<std::size_t>(row - 1)].contacts[0] != 0;
    if (row > 0) {
      const std::int64_t frame = row - 1;
      if (frame == 50) expected.push = 5.0, expected.vy = -20.0;
      if (frame == 60) dt_s = 0.25;
      if (frame == 70) expected.vy = 33.0;
      if (frame == 85) expected.vy = -44.0;
      is_held = frame >= 80 && frame < 90;
      if (!is_held) expected.step(dt_s);
    }
    const auto& kept = rows.rows[static_cast<std::size_t>(row)];
    ASSERT_EQ(kept.step, row);
    ASSERT_EQ(kept.dt_s, dt_s);
    ASSERT_EQ(kept.state[0], word_of(expected.y)) << row;
    ASSERT_EQ(kept.state[1], word_of(expected.vy)) << row;
    ASSERT_EQ(kept.outputs[0], word_of(10.0 - expected.y));
    const bool is_on_floor = row > 0 && !is_held && expected.floor;
    ASSERT_EQ(kept.contacts[0] != 0, is_on_floor) << row;
    if (is_on_floor && !was_on_floor) ++contacts;
    if (expected.vy < 0.0 && !up) up = row;
  }
  EXPECT_GT(contacts, 2);
  EXPECT_EQ(summary.contacts[0], contacts);
  EXPECT_EQ(rows.ended.size(), static_cast<std::size_t>(contacts));
  EXPECT_EQ(rows.ended[0].t_s, rows.rows[static_cast<std::size_t>(rows.ended[0].step)].t_s);
  EXPECT_EQ(summary.steps, 200);
  EXPECT_EQ(summary.final, rows.rows.back().state);
  EXPECT_EQ(summary.inputs_set, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(summary.actions_done, std::vector<std::uint8_t>{1});
  EXPECT_TRUE(summary.properties[0].holds);
  EXPECT_FALSE(summary.properties[0].step);
  EXPECT_EQ(summary.properties[2].holds, false);
  EXPECT_EQ(summary.properties[2].step, up);
  EXPECT_FALSE(summary.early_end);
}

TEST(DescribedRun, ParametersAreSetBeforeInputsAndTheseBeforeTheState) {
  DescribedScenario scenario = scenario_for_test(1);
  scenario.start = {{2, word_of(3)}};
  scenario.inputs = {{1, word_of(2)}};
  scenario.parameters = {{1, word_of(1)}};
  scenario.events = {event_for_test(0, SetValues{{{1, word_of(4)}}, {{2, word_of(5)}}})};
  RowsForTest rows;
  static_cast<void>(play_for_test(core_for_test<Bouncer>(), scenario, rows));
  EXPECT_EQ(rows.rows[0].state[2], 123U);
  EXPECT_EQ(rows.rows[1].state[2], 12345U);
}

struct Follower {
  std::int16_t x = 0;
  int wanted = 0;
  int seen = 0;
  void step(double /*dt_s*/) { seen = wanted; }
  void state(auto&& see) {
    see("seen", seen);
    see(
        "now", [&] { return wanted; }, [&](int /*given*/) {});
  }
  void inputs(auto&& see) { see("wanted", wanted); }
};

TEST(DescribedRun, AnInputArrayGivesAValueForEachFrameHeldOrNot) {
  DescribedScenario scenario = scenario_for_test(4);
  scenario.input_arrays = {{0, {11, 12, 13, 14}}};
  scenario.events = {event_for_test(1, Hold{}), event_for_test(2, Go{})};
  RowsForTest rows;
  const DescribedSummary summary = play_for_test(core_for_test<Follower>(), scenario, rows);
  std::vector<Word> now;
  std::vector<Word> seen;
  for (const auto& row : rows.rows) seen.push_back(row.state[0]), now.push_back(row.state[1]);
  EXPECT_EQ(now, (std::vector<Word>{11, 11, 12, 13, 14}));  // Value 0 before row 0, too.
  EXPECT_EQ(seen, (std::vector<Word>{0, 11, 11, 13, 14}));
  EXPECT_EQ(summary.inputs_set, std::vector<std::uint8_t>{1});
  EXPECT_FALSE(summary.at_rest_since_s);  // Nothing is in px.
}

enum class Mood : std::int8_t { low = -2, high = 2 };
struct Mixed {
  double x = 1.5;
  float f = 0.1F;
  int i = -5;
  std::uint8_t u = 200;
  bool b = true;
  Mood mood = Mood::low;
  int frame = 0;
  void step(double /*dt_s*/) {
    ++frame, ++i, ++u, b = !b;
    x = frame == 5000 ? -std::numeric_limits<double>::quiet_NaN() : x + 0.25;
    mood = b ? Mood::low : Mood::high;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("f", f);
    see("i", i);
    see("u", u);
    see("b", b);
    see("mood", mood);
  }
  void contacts(auto&& see) const {
    for (int flag = 0; flag < 10; ++flag) see("c" + std::to_string(flag), frame % (flag + 1) == 0);
  }
};

TEST(DescribedRun, TheStateHashIsThatOfRowsPackedByHand) {
  RowsForTest rows;
  const DescribedSummary summary = play_for_test(core_for_test<Mixed>(), scenario_for_test(6000), rows);
  // The first value that is not finite ends the run; its row is kept.
  ASSERT_TRUE(summary.early_end);
  EXPECT_EQ(summary.early_end->step, 5000);
  EXPECT_TRUE(summary.early_end->is_non_finite);
  EXPECT_EQ(summary.early_end->what, "x_px is not finite");
  ASSERT_EQ(rows.rows.size(), 5001U);

  Mixed core;
  std::vector<std::byte> digests;
  std::vector<std::byte> block;
  const auto put = [&](auto value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte) block.push_back(static_cast<std::byte>((bits >> (8 * byte)) & 255U));
  };
  for (int row = 0; row <= 5000; ++row) {
    if (row > 0) core.step(0.0);
    put(row == 0 ? 0.0 : 1.0 / 60.0);
    if (row == 5000)
      put(std::uint64_t{0x7ff8000000000000});
    else
      put(core.x);
    put(static_cast<double>(core.f));
    put(static_cast<std::int64_t>(core.i));
    put(static_cast<std::uint64_t>(core.u));
    put(static_cast<std::uint64_t>(core.b));
    put(static_cast<std::int64_t>(core.mood));
    unsigned flags = 0;
    for (int flag = 0; flag < 10; ++flag)
      if (row > 0 && row % (flag + 1) == 0) flags |= 1U << flag;
    block.push_back(static_cast<std::byte>(flags & 255U));
    block.push_back(static_cast<std::byte>(flags >> 8));
    if (row % 4096 == 4095 || row == 5000) {
      const Digest of_block = digest(block);
      const auto bytes = std::as_bytes(std::span(of_block));
      digests.insert(digests.end(), bytes.begin(), bytes.end());
      block.clear();
    }
  }
  EXPECT_EQ(hex(summary.state_hash), hex(digest(digests)));
  ASSERT_EQ(rows.blocks.size(), 2U);
  EXPECT_EQ(rows.blocks[1].keyframe.step, 4096);
  EXPECT_EQ(rows.blocks[1].keyframe.state, rows.rows[4096].state);
  EXPECT_EQ(rows.blocks[1].keyframe.timeline.time_s(), rows.rows[4096].t_s);
}

struct Thrower : OnePlace {
  int rows_left = 3;
  void step(double /*dt_s*/) {
    x += 1.0;
    if (x == 5.0) throw std::runtime_error("out of fuel");
  }
  void properties(auto&& see) const {
    see.always("p", x < 3.0 || x > 7.0 || (rows_left > 3 ? throw 1 : true));
  }
};

TEST(DescribedRun, WhatACoreThrowsEndsTheRun) {
  RowsForTest rows;
  DescribedSummary summary = play_for_test(core_for_test<Thrower>(), scenario_for_test(10), rows);
  ASSERT_TRUE(summary.early_end);
  EXPECT_EQ(summary.early_end->step, 5);
  EXPECT_EQ(summary.early_end->what, "out of fuel");
  EXPECT_FALSE(summary.early_end->is_non_finite);
  EXPECT_EQ(rows.rows.size(), 5U);
  EXPECT_EQ(summary.steps, 4);
  EXPECT_EQ(summary.final, std::vector<Word>{word_of(4.0)});
  // Row 0, too.
  DescribedScenario scenario = scenario_for_test(10);
  scenario.start = {{0, word_of(std::numeric_limits<double>::infinity())}};
  RowsForTest first;
  summary = play_for_test(core_for_test<Thrower>(), scenario, first);
  ASSERT_TRUE(summary.early_end);
  EXPECT_EQ(summary.early_end->step, 0);
  EXPECT_EQ(first.rows.size(), 1U);
}

// Goes on behind a row that ends the run, and throws there.
struct Overflowing {
  double x = 1e308;
  int frame = 0;
  void step(double /*dt_s*/) {
    if (++frame == 100) x *= 10.0;
    if (frame == 102) throw std::runtime_error("too late");
  }
  void state(auto&& see) {
    see("x", x);
    see("frame", frame);
  }
};
TEST(DescribedRun, ARowThatIsNotFiniteEndsTheRunWhateverItsStepsDoBehindIt) {
  RowsForTest rows;
  const DescribedSummary summary = play_for_test(core_for_test<Overflowing>(), scenario_for_test(200), rows);
  ASSERT_TRUE(summary.early_end);
  EXPECT_EQ(summary.early_end->step, 100);
  EXPECT_EQ(summary.early_end->what, "x is not finite");
  EXPECT_EQ(rows.rows.size(), 101U);
}

template <std::size_t kElements>
struct Changeable {
  std::vector<double> xs{1.0, 2.0};
  void step(double /*dt_s*/) { xs.resize(kElements); }
  void state(auto&& see) { see("xs_px", xs); }
};
TEST(DescribedRun, ARangeWhoseLengthChangesEndsIt) {
  RowsForTest rows;
  for (const auto& [core, elements] :
       {std::pair(core_for_test<Changeable<1>>(), std::string("1")), {core_for_test<Changeable<3>>(), "3"}}) {
    const DescribedSummary summary = play_for_test(core, scenario_for_test(3), rows);
    ASSERT_TRUE(summary.early_end);
    EXPECT_EQ(summary.early_end->step, 1);
    EXPECT_EQ(summary.early_end->what, "xs_px: has " + elements + " elements, not the 2 of its description");
  }
  EXPECT_EQ(rows.rows.size(), 2U);  // Row 0 of each.
}

// Moves for a second, then stands.
struct Slider {
  double x = 0.0;
  int frame = 0;
  void step(double /*dt_s*/) {
    if (++frame <= 60) x += 1.0;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("frame", frame);
  }
};
TEST(DescribedRun, RestBeginsWithTheLastRowThatIsFarFromTheOneBefore) {
  RowsForTest rows;
  EXPECT_EQ(play_for_test(core_for_test<Slider>(), scenario_for_test(120), rows).at_rest_since_s, 1.0);
  EXPECT_EQ(play_for_test(core_for_test<Slider>(), scenario_for_test(119), rows).at_rest_since_s,
            std::nullopt);
}

}  // namespace
}  // namespace hyrax

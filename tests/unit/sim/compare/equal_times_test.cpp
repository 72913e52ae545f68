// Two runs at equal times: between rows, at several rows of one time, and around what no straight line shows.
#include "sim/compare/equal_times.h"

#include <gtest/gtest.h>

#include <limits>

namespace hyrax {
namespace {

// Row k of a run, at t and x.
using Places = std::vector<std::pair<double, double>>;

Columns rows_of(const Places& places) {
  Columns rows;
  for (const auto& [t_s, x_px] : places)
    rows.append({.step = static_cast<std::int64_t>(rows.size()), .t_s = t_s, .x_px = x_px});
  return rows;
}

struct Walked {
  Distance distance;
  std::vector<double> times_s;
};
Walked walk(const Places& a, const Places& b, std::vector<Input> inputs_a = {},
            std::vector<Input> inputs_b = {}) {
  Walked walked;
  walked.distance =
      walk_equal_times({batches_of(rows_of(a)), std::move(inputs_a)},
                       {batches_of(rows_of(b)), std::move(inputs_b)}, [&](const Row& row, const Row& other) {
                         EXPECT_EQ(row.t_s, other.t_s);
                         walked.times_s.push_back(row.t_s);
                       });
  return walked;
}

TEST(EqualTimes, AreTheRowTimesOfEitherUpToTheEarlierEnd) {
  const Places slow = {{0, 0}, {1, 10}, {2, 20}, {3, 30}},
               fast = {{0, 0}, {0.75, 7.5}, {1.5, 15}, {2.25, 22.5}};
  const Walked walked = walk(slow, fast);
  EXPECT_EQ(walked.times_s, (std::vector<double>{0, 0.75, 1, 1.5, 2, 2.25}));
  EXPECT_FALSE(walked.distance.largest) << "both are on one line at every time";
  EXPECT_TRUE(walked.distance.is_at_equal_times);
  EXPECT_EQ(walk(fast, slow).times_s, walked.times_s);
}

TEST(EqualTimes, FindWhereTheRunsAreFarthestApart) {
  const Places slow = {{0, 0}, {1, 10}, {2, 10}}, fast = {{0, 0}, {0.75, 7.5}, {1.5, 15}, {2.25, 8}};
  const WorstDistance largest = walk(slow, fast).distance.largest.value();
  EXPECT_EQ(largest.px, 5.0);
  EXPECT_EQ(largest.t_s, 1.5);
  EXPECT_EQ(largest.step, 1) << "the first run's last row up to the time";
  EXPECT_EQ(walk(fast, slow).distance.largest->step, 2);
}

// The line before them ends at the first, and the one after them begins at the last.
TEST(EqualTimes, OfSeveralRowsOfOneTimeTakeTheLast) {
  const Places zero_frames = {{0, 0}, {1, 10}, {1, 40}, {1, 50}, {2, 60}};
  const Walked walked = walk(zero_frames, {{0, 0}, {0.5, 5}, {1, 50}, {1.5, 55}, {2, 60}});
  EXPECT_EQ(walked.times_s, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_FALSE(walked.distance.largest);
}

// Whichever run has the input; a fling or a hitch is no jump.
TEST(EqualTimes, AfterAJumpAreLeftOutForTwoRows) {
  const Places jumping = {{0, 0}, {1, 1}, {2, 2}, {3, 90}, {4, 91}, {5, 92}};
  const Places other = {{0, 0}, {1.5, 1.5}, {2.5, 2.5}, {3.5, 3.5}, {4.5, 91.5}, {5, 92}};
  for (const Action& action :
       {Action(Place{{90, 0}}), Action(Grab{}), Action(Release{}), Action(Resize{Size{9, 9}, {}})}) {
    const std::vector<Input> inputs = {{2, action}};  // Its row is 3.
    for (const Walked& walked : {walk(jumping, other, inputs), walk(other, jumping, {}, inputs)}) {
      EXPECT_EQ(walked.times_s, (std::vector<double>{0, 1, 1.5, 2, 4.5, 5}));
      EXPECT_FALSE(walked.distance.largest);
      EXPECT_EQ(walked.distance.frames_left_out, 1);
    }
  }
  for (const Action& action : {Action(Fling{}), Action(Stop{}), Action(Hitch{1.0})}) {
    const Walked walked = walk(jumping, other, {{2, action}});
    EXPECT_GT(walked.distance.px(), 40.0);
    EXPECT_EQ(walked.distance.frames_left_out, 0);
  }
  const std::vector<Input> two = {{1, Grab{}}, {2, Place{}}};
  EXPECT_EQ(walk(jumping, other, two, two).distance.frames_left_out, 2);
  EXPECT_EQ(walk(jumping, other, two, two).times_s, (std::vector<double>{0, 1, 5}));
}

TEST(EqualTimes, ARowThatIsNotFiniteIsInfinitelyFar) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Walked walked = walk({{0, 0}, {1, 10}, {2, nan}}, {{0, 0}, {1.5, 15}, {3, 30}});
  EXPECT_EQ(walked.times_s, (std::vector<double>{0, 1, 2})) << "no line leads to it";
  EXPECT_EQ(walked.distance.px(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(walked.distance.largest->t_s, 2.0);
}

TEST(RowCursor, ReadsBatchAfterBatch) {
  std::int64_t next = 0;
  RowCursor cursor([&next](Columns& batch) {
    batch.clear();
    for (int row = 0; row < 3 && next < 8; ++row) batch.append({.step = next++});
  });
  for (std::int64_t step = 0; step < 8; ++step, cursor.next()) {
    ASSERT_FALSE(cursor.is_done());
    EXPECT_EQ(cursor.row().step, step);
  }
  EXPECT_TRUE(cursor.is_done());
}

}  // namespace
}  // namespace hyrax

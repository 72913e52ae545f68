// Golden files: what is kept of a run is read again, short and long.
#include "tools/store/golden_file.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/compare/played_run.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/store/golden_summary.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

constexpr std::int64_t kLong = 3 * static_cast<std::int64_t>(kBlockRows) + 99;

Scenario long_fling(std::int64_t steps = kLong) {
  Scenario scenario = fling_at(60.0, steps,
                               {{std::int64_t{3}, Grab{}},
                                {std::int64_t{8000}, Resize{Size{1000, 700}, {}}},
                                {std::int64_t{9000}, Release{{900.0, -1500.0}}}});
  scenario.clock.jitter = Jitter{Jitter::Kind::normal, 0.004, 9};
  return scenario;
}

class GoldenFile : public testing::Test {
 protected:
  StoredRun write_and_read(const StoredRun& run) const {
    AtomicFile target(path_);
    write_golden(target, path_, run);
    target.commit();
    return read_golden(path_);
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("golden.h5");
};

// The checksum is of all but the name, the rows, and the checks of rows.
void expect_same_contents(const StoredRun& a, const StoredRun& b) {
  EXPECT_EQ(contents_checksum(a), contents_checksum(b));
  EXPECT_EQ(a.scenario.name, b.scenario.name);
}

TEST_F(GoldenFile, OfAShortRunKeepsEveryRowAndItsCoresNameAndConstants) {
  StoredRun kept = kept_run(eventful_fling());
  for (const std::optional<Constants>& constants :
       {std::optional(constants_of({1.0, 2.0, 3.0, 4.0, 5.0})), std::optional<Constants>()}) {
    kept.constants = constants;
    kept.physics = constants ? "hyrax-physics/1" : "elastic_box";
    const StoredRun read = write_and_read(kept);
    expect_same_contents(kept, read);
    ASSERT_EQ(read.rows.size(), kept.rows.size());
    EXPECT_TRUE(read.blocks.empty());
    for (std::size_t row = 0; row < read.rows.size(); ++row)
      EXPECT_TRUE(same_row(read.rows.row(row), kept.rows.row(row))) << row;
  }
}

TEST_F(GoldenFile, OfMoreThanTwoThousandRowsKeepsItsBlocks) {
  EXPECT_EQ(write_and_read(kept_run(fling_at(60.0, 1999))).rows.size(), 2000u);
  EXPECT_EQ(write_and_read(kept_run(fling_at(60.0, 2000))).blocks.size(), 1u);
  for (const std::int64_t steps : {18 * static_cast<std::int64_t>(kBlockRows), kLong}) {
    const StoredRun kept = kept_run(long_fling(steps));
    const StoredRun read = write_and_read(kept);
    expect_same_contents(kept, read);
    EXPECT_EQ(read.rows.size(), 0u);
    ASSERT_EQ(read.blocks.size(), kept.blocks.size());
    for (std::size_t block = 0; block < read.blocks.size(); ++block) {
      EXPECT_EQ(read.blocks[block].checks, kept.blocks[block].checks);
      EXPECT_EQ(read.blocks[block].checks.empty(), block >= kCheckedBlocksMax) << block;
    }
    EXPECT_TRUE(read.blocks[2].keyframe.window == (Size{1000, 700}));
    EXPECT_TRUE(read.blocks[2].keyframe.is_held);
  }
  const TrajectoryFile file(path_);
  EXPECT_EQ(file.head().steps, kLong);
  EXPECT_EQ(file.row_count(), 5);  // Four keyframes and the last row.
}

TEST_F(GoldenFile, OfALongRunAtRestKeepsARepeatedBlockOnce) {
  const StoredRun kept = kept_run(fling_at(240.0, 1'000'000));
  const StoredRun read = write_and_read(kept);
  expect_same_contents(kept, read);
  EXPECT_LT(read.blocks.size(), 20u);
  EXPECT_LT(std::filesystem::file_size(path_), 500'000u);
  EXPECT_TRUE(compare(read, kept.scenario).agrees);
}

TEST_F(GoldenFile, IsTheSameBytesEachTimeAndJudgedAsTheRunThatWasKept) {
  for (const Scenario& scenario : {eventful_fling(), long_fling(), fling_at(60.0, 0)}) {
    write_and_read(kept_run(scenario));
    const std::string first = bytes_of(path_);
    const StoredRun read = write_and_read(kept_run(scenario));
    EXPECT_TRUE(first == bytes_of(path_));
    EXPECT_TRUE(compare(read, scenario).agrees);
    const std::int64_t step = read.steps / 2;
    const Comparison differing = compare(read, scenario, {.fault = one_ulp(step, "vx")});
    ASSERT_TRUE(differing.first);
    EXPECT_EQ(differing.first->step, step);
  }
}

}  // namespace
}  // namespace hyrax

// Runs that end before, on and after every boundary of blocks, batches and steps between recorded rows: files
// and sinks hold the rows of the plain loop.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/plain_replay.h"
#include "tests/unit/tools/store/stored_flings.h"

namespace hyrax {
namespace {

constexpr std::int64_t kBlock = kBlockRows, kLongest = 65'537;
constexpr std::int64_t kLengths[] = {
    0, 1, kBlock - 2, kBlock - 1, kBlock, kBlock + 1, 2 * kBlock, 2 * kBlock + 1, 65'535, 65'536, kLongest};

// One that comes to rest and repeats, and one of which no step is skipped.
Scenario run_of(bool repeats, std::int64_t steps) {
  Scenario scenario = fling_at(60.0, steps);
  if (!repeats) scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.1, 3};
  return scenario;
}

class RunLengths : public testing::TestWithParam<bool> {
 protected:
  RunLengths() : plain_(PlainReplay(run_of(GetParam(), kLongest)).play()) {}

  // A shorter run is the beginning of the longest: rows 0, every, 2 every, ..., and the last.
  [[nodiscard]] std::vector<Row> expected(std::int64_t steps, std::int64_t every) const {
    std::vector<Row> rows;
    for (const Row& row : plain_.rows)
      if (row.step <= steps && (row.step % every == 0 || row.step == steps)) rows.push_back(row);
    return rows;
  }

  const PlainRun plain_;
  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
};

TEST_P(RunLengths, HaveTheRowsAndTheHashOfThePlainLoopWhateverIsRecorded) {
  PlainRun beginning;
  for (const std::int64_t steps : kLengths) {
    beginning.rows.assign(plain_.rows.begin(), plain_.rows.begin() + steps + 1);
    const std::string state_hash = beginning.state_hash();
    for (const std::int64_t every :
         {std::int64_t{1}, std::int64_t{3}, kBlock - 1, kBlock, kBlock + 1, steps + 1}) {
      SCOPED_TRACE(testing::Message() << steps << " steps, every " << every);
      Scenario scenario = run_of(GetParam(), steps);
      scenario.record_every = every;
      write_run(path_, scenario);
      TraceSink trace(RowSink::Wants{.rows_every = every});
      EXPECT_EQ(hex(replay(shipped_core(), scenario, trace).state_hash), state_hash);
      const std::vector<Row> rows = expected(steps, every);
      ASSERT_EQ(rows.back().step, steps);
      ASSERT_TRUE(same_rows(rows_of(TrajectoryFile(path_)), rows));
      ASSERT_TRUE(same_rows(trace.rows(), rows));
    }
  }
}

TEST_P(RunLengths, AreReadFromAnyRow) {
  write_run(path_, run_of(GetParam(), kLongest));
  const TrajectoryFile file(path_);
  for (const std::int64_t length : kLengths) {
    const std::int64_t first = std::max<std::int64_t>(length - 1, 0),
                       count = std::min<std::int64_t>(3, kLongest + 1 - first);
    const Columns part = file.rows(first, count);
    ASSERT_EQ(std::ssize(part.step), count);
    for (std::int64_t row = 0; row < count; ++row)
      ASSERT_TRUE(same_row(part.row(static_cast<std::size_t>(row)),
                           plain_.rows[static_cast<std::size_t>(first + row)]))
          << first;
  }
}

INSTANTIATE_TEST_SUITE_P(OfARun, RunLengths, testing::Bool(),
                         [](const auto& test) { return test.param ? "ThatRepeats" : "WithJitter"; });

}  // namespace
}  // namespace hyrax

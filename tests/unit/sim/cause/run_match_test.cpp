// What of a replay is a stored run's: one place of it is changed, wherever it is.
#include "sim/cause/run_match.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/replay/kept_run.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);

class StoredRuns : public testing::Test {
 protected:
  [[nodiscard]] RunMatch match_of(const StoredRun& run) const { return match(shipped_core(), scenario, run); }

  Scenario scenario = fling_at(60.0, 300);
};

TEST_F(StoredRuns, MatchInRowsTimesAndContacts) {
  const StoredRun whole = kept_run(scenario);
  EXPECT_TRUE(match_of(whole).is_whole());
  for (const std::size_t row : {0U, 1U, 150U, 299U, 300U}) {
    StoredRun run = whole;
    run.rows.t_s[row] += 1.0;
    EXPECT_FALSE(match_of(run).times) << row;
    EXPECT_TRUE(match_of(run).rows) << row;
    run = whole;
    run.rows.vx_px_per_s[row] += 1.0;
    EXPECT_FALSE(match_of(run).rows) << row;
  }
  void (*const changes[])(StoredRun&, std::size_t) = {
      [](StoredRun& run, std::size_t contact) { ++run.contacts[contact].step; },
      [](StoredRun& run, std::size_t contact) { ++run.contacts[contact].last_step; },
      [](StoredRun& run, std::size_t contact) { run.contacts[contact].wall = Wall::top; },
      [](StoredRun& run, std::size_t contact) { run.contacts[contact].vx_after_px_per_s += 1.0; },
      [](StoredRun& run, std::size_t) { ++run.contacts_total; },
      [](StoredRun& run, std::size_t) { run.contacts.pop_back(); }};
  for (const auto& change : changes)
    for (std::size_t contact = 0; contact < whole.contacts.size(); ++contact) {
      StoredRun run = whole;
      change(run, contact);
      EXPECT_FALSE(match_of(run).contacts) << contact;
      EXPECT_TRUE(match_of(run).rows) << contact;
    }
}

TEST_F(StoredRuns, MatchInBlocksHoweverTheyAreCounted) {
  for (const std::int64_t steps : {kRows - 1, kRows, 5 * kRows - 1, 5 * kRows + 7}) {
    scenario = fling_at(60.0, steps);
    const StoredRun whole = kept_run(scenario);
    EXPECT_TRUE(match_of(whole).is_whole()) << steps;
    for (std::size_t block = 0; block < whole.blocks.size(); ++block) {
      StoredRun run = whole;
      run.blocks[block].keyframe.row.t_s += 1.0;
      EXPECT_FALSE(match_of(run).times) << steps << ", block " << block;
      run = whole;
      run.blocks[block].digest[0] ^= 1;
      EXPECT_FALSE(match_of(run).rows) << steps << ", block " << block;
    }
  }
}

// Those of the block that differs, and of the one before it.
TEST_F(StoredRuns, ShowTheStepsAroundTheFirstDifference) {
  const Scenario even = fling_at(60.0, 4 * kRows + 9);
  for (const std::int64_t frame : {std::int64_t{3}, kRows, 2 * kRows - 2, 2 * kRows - 1, 4 * kRows + 5}) {
    Scenario flung = even;
    flung.events = {{frame, Fling{{-900.0, -900.0}}}};
    const std::vector<ObservedStep> steps = observed_steps(kept_run(flung), kept_run(even), shipped_core());
    const std::int64_t block = (frame + 1) / kRows;  // Of the first row that differs.
    EXPECT_EQ(steps.front().step, std::max<std::int64_t>(0, block - 1) * kRows + 1) << frame;
    EXPECT_GE(steps.back().step, std::min((block + 1) * kRows - 1, 4 * kRows + 9)) << frame;
    EXPECT_EQ(std::ranges::count(steps, true, &ObservedStep::follows_input), 1) << frame;
    flung.events = {{frame, Resize{Size{1900, 1060}, {}}}, {frame, Hitch{0.1}}};  // They set no state.
    EXPECT_EQ(std::ranges::count(observed_steps(kept_run(flung), kept_run(even), shipped_core()), true,
                                 &ObservedStep::follows_input),
              0);
  }
}

}  // namespace
}  // namespace hyrax

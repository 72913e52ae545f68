// What is written into a trajectory file is read from it, bit for bit: rows in any batches, contacts that end
// late, runs of any length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/plain_replay.h"
#include "tests/unit/tools/store/stored_flings.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_parts.h"

namespace hyrax {
namespace {

class StoredRunFile : public testing::Test {
 protected:
  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
};

TEST_F(StoredRunFile, HoldsRowsInTheirOrderWhateverBatchesTheyAreWrittenIn) {
  constexpr auto kBatchRows = static_cast<std::int64_t>(RowTable::kBatch);
  for (const std::int64_t steps :
       {std::int64_t{0}, kBatchRows - 2, kBatchRows - 1, kBatchRows, 2 * kBatchRows + 3}) {
    const Scenario scenario = fling_at(60.0, steps);
    TrajectoryWriter writer(path_, scenario, steps);
    for (std::int64_t step = 0; step <= steps; ++step)
      writer.row({.step = step, .x_px = static_cast<double>(step)});
    writer.finish({{steps, "hyrax-physics/1", std::string(32, '0')}, scenario}, {}, 0);
    std::int64_t in_place = 0;
    for (const Row& row : rows_of(TrajectoryFile(path_)))
      in_place += static_cast<double>(row.step) == row.x_px && row.step == in_place;
    EXPECT_EQ(in_place, steps + 1);
  }
}

// A small file may hold a scenario whose parsing takes more memory than reading a file of that size may take.
TEST_F(StoredRunFile, IsOpenedHoweverCostlyItsScenario) {
  std::string scenario = R"({"format": "hyrax-scenario/1", "name": "costly",
      "window": {"width_px": 900, "height_px": 900}, "sprite": {"width_px": 9, "height_px": 9},
      "start": {"x_px": 1, "y_px": 1}, "clock": {"dt_s": [0.0625)";
  for (int frame = 1; frame < 1'000'000; ++frame) scenario += ",1";
  write_run(path_, fling_at(60.0, 3));
  {
    const h5::Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    H5Adelete(file, "scenario");
    h5::write_attribute(file, "scenario", scenario + "]}}");
  }
  EXPECT_EQ(step_count(TrajectoryFile::open(path_).head().scenario), 1'000'000);
}

TEST(InputRecord, ThatNoInputHasIsNone) {
  EXPECT_FALSE(input_of({0, 8, 0.0, 0.0}));
  EXPECT_FALSE(input_of({0, 3, 800.5, 600.0}));
  EXPECT_FALSE(input_of({0, 3, -1.0, 600.0}));
  EXPECT_FALSE(input_of({0, 4, 64.0, 1e300}));
  EXPECT_FALSE(input_of({0, 4, std::nan(""), 32.0}));
  EXPECT_FALSE(input_of({0, 5, 0.5, 1.0}));
  EXPECT_FALSE(input_of({0, 6, -0.0, 0.0}));
}

constexpr auto kBatch = static_cast<std::int64_t>(ContactTable::kBatch);

Contact contact_number(std::int64_t number) {
  const auto value = static_cast<double>(number);
  return {.step = 2 * number + 1,
          .last_step = 2 * number + 1,
          .wall = kWalls[static_cast<std::size_t>(number % 4)],
          .t_s = value / 8.0,
          .x_px = value,
          .y_px = -value,
          .vx_before_px_per_s = value + 0.25,
          .vy_before_px_per_s = value + 0.5,
          .vx_after_px_per_s = value - 0.25,
          .vy_after_px_per_s = value - 0.5,
          .overshoot_px = value * 3.0};
}

class Contacts : public StoredRunFile {
 protected:
  // A file with so many contacts, of which some are extended after later ones were written.
  std::vector<Contact> write(std::int64_t count, const std::vector<std::int64_t>& lasting) {
    std::vector<Contact> contacts;
    TrajectoryWriter writer(path_, fling_at(60.0, 0), 0);
    writer.row({});
    for (std::int64_t number = 0; number < count; ++number) {
      contacts.push_back(contact_number(number));
      writer.contact_began(contacts.back());
    }
    for (const std::int64_t index : lasting) {
      contacts[static_cast<std::size_t>(index)].last_step += 1'000'000;
      writer.contact_ended(index, contacts[static_cast<std::size_t>(index)].last_step);
    }
    writer.finish({{0, "hyrax-physics/1", std::string(32, '0')}, fling_at(60.0, 0)}, {}, count);
    return contacts;
  }
};

TEST_F(Contacts, AreKeptFewOrManyAndMayEndAfterTheyWereWritten) {
  std::string first;  // The bytes of the most, which are written twice.
  for (const std::int64_t count :
       {std::int64_t{0}, std::int64_t{1}, kBatch - 1, kBatch, kBatch + 1, 2 * kBatch + 10, 2 * kBatch + 10}) {
    std::vector<std::int64_t> lasting = {0, kBatch - 1, kBatch, 2 * kBatch - 1, 2 * kBatch, 2 * kBatch + 9};
    std::erase_if(lasting, [&](std::int64_t index) { return index >= count; });
    first = bytes_of(path_);
    const std::vector<Contact> contacts = write(count, lasting);
    EXPECT_TRUE(same_contacts(TrajectoryFile(path_).contacts(), contacts)) << count;
    EXPECT_EQ(TrajectoryFile(path_).contacts_total(), count);
    EXPECT_TRUE(TrajectoryFile(path_).inputs().empty());
  }
  EXPECT_TRUE(first == bytes_of(path_));
}

// Runs that end before, on and after every boundary of blocks, batches and steps between recorded rows: files
// and sinks hold the rows of the plain loop.
TEST_F(StoredRunFile, HasTheRowsAndTheHashOfThePlainLoopWhateverIsRecordedAndFromAnyRow) {
  constexpr std::int64_t kBlock = kBlockRows, kLongest = 65'537;
  constexpr std::int64_t kLengths[] = {
      0, 1, kBlock - 2, kBlock - 1, kBlock, kBlock + 1, 2 * kBlock, 2 * kBlock + 1, 65'535, 65'536, kLongest};
  for (const bool repeats : {true, false}) {  // Of the second no step is skipped.
    Scenario scenario = fling_at(60.0, kLongest);
    if (!repeats) scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.1, 3};
    const PlainRun plain = PlainReplay(scenario).play();
    PlainRun beginning;  // A shorter run is the beginning of the longest.
    for (const std::int64_t steps : kLengths) {
      scenario.length = steps;
      beginning.rows.assign(plain.rows.begin(), plain.rows.begin() + steps + 1);
      const std::string state_hash = beginning.state_hash();
      for (const std::int64_t every :
           {std::int64_t{1}, std::int64_t{3}, kBlock - 1, kBlock, kBlock + 1, steps + 1}) {
        SCOPED_TRACE(testing::Message() << repeats << ", " << steps << " steps, every " << every);
        scenario.record_every = every;
        write_run(path_, scenario);
        TraceSink trace(RowSink::Wants{.rows_every = every});
        EXPECT_EQ(hex(replay(shipped_core(), scenario, trace).state_hash), state_hash);
        std::vector<Row> rows;
        for (const Row& row : beginning.rows)
          if (row.step % every == 0 || row.step == steps) rows.push_back(row);
        ASSERT_EQ(rows.back().step, steps);
        ASSERT_TRUE(same_rows(rows_of(TrajectoryFile(path_)), rows));
        ASSERT_TRUE(same_rows(trace.rows(), rows));
      }
    }
    scenario.record_every = 1;
    write_run(path_, scenario);
    const TrajectoryFile file(path_);
    for (const std::int64_t length : kLengths) {
      const std::int64_t first = std::max<std::int64_t>(length - 1, 0),
                         count = std::min<std::int64_t>(3, kLongest + 1 - first);
      const Columns part = file.rows(first, count);
      ASSERT_EQ(std::ssize(part.step), count);
      for (std::int64_t row = 0; row < count; ++row)
        ASSERT_TRUE(same_row(part.row(static_cast<std::size_t>(row)),
                             plain.rows[static_cast<std::size_t>(first + row)]))
            << first;
    }
  }
}

}  // namespace
}  // namespace hyrax

// What is written into a trajectory file is read from it, bit for bit.
#include "tools/store/trajectory_file.h"
#include "tools/store/input_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/tools/store/stored_flings.h"

namespace hyrax {
namespace {

class StoredRunFile : public testing::Test {
 protected:
  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
};

TEST_F(StoredRunFile, HoldsRowsInTheirOrderWhateverBatchesTheyComeIn) {
  constexpr auto kBatchRows = static_cast<std::int64_t>(RowTable::kBatch);
  std::vector<std::int64_t> ends;  // Of the batches.
  for (const std::int64_t rows :
       {std::int64_t{1}, kBatchRows, kBatchRows - 1, std::int64_t{2}, kBatchRows + 1, std::int64_t{3}})
    ends.push_back(rows + (ends.empty() ? 0 : ends.back()));
  const std::int64_t steps = ends.back() - 1;
  const Scenario scenario = fling_at(60.0, steps);
  TrajectoryWriter writer(path_, scenario, steps);
  Columns batch;
  for (std::int64_t step = 0, at = 0; step <= steps; ++step) {
    batch.append({.step = step, .x_px = static_cast<double>(step)});
    if (step + 1 != ends[static_cast<std::size_t>(at)]) continue;
    writer.rows(std::exchange(batch, {}));
    ++at;
  }
  writer.finish({scenario, steps, "hyrax-physics/1", std::string(32, '0'), {}}, {}, 0);
  std::int64_t in_place = 0;
  for (const Row& row : rows_of(TrajectoryFile(path_)))
    in_place += static_cast<double>(row.step) == row.x_px && row.step == in_place;
  EXPECT_EQ(in_place, steps + 1);
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

}  // namespace
}  // namespace hyrax

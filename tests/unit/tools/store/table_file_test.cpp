// A study's tables in HDF5.
#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"
#include "tools/store/hdf5.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

const StudyHead kHead{"some-study", "what was studied"};

std::vector<Table> some_tables() {
  return {{"first",
           "numbers",
           {{"error", "px", "distance", std::vector<double>{1.5, 2.5}},
            {"rows", "1", "count", std::vector<std::int64_t>{3, 4}},
            {"method", "", "name", std::vector<std::string>{"exact", "the paper's"}}}},
          {"empty", "none", {{"text", "", "nothing", std::vector<std::string>{}}}}};
}

class StudyFile : public testing::Test {
 protected:
  const TempFolder folder_;
  const std::string path_ = folder_.at("study.h5");
};

TEST_F(StudyFile, HoldsAGroupATableAndADatasetAColumn) {
  write_study_file(path_, kHead, some_tables());
  const h5::Handle file = h5::open_file(path_);
  EXPECT_EQ(h5::read_text_attribute(file, "format"), "hyrax-study/1");
  EXPECT_EQ(h5::read_text_attribute(file, "study"), "some-study");
  const h5::Handle error(H5Dopen2(file, "first/error", H5P_DEFAULT), H5Dclose);
  EXPECT_EQ(h5::read_text_attribute(error, "units"), "px");
  EXPECT_EQ(h5::read_text_attribute(error, "long_name"), "distance");
  double values[2] = {};
  ASSERT_GE(H5Dread(error, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
  EXPECT_EQ(values[1], 2.5);
  const h5::Handle provenance(H5Gopen2(file, "provenance", H5P_DEFAULT), H5Gclose);
  EXPECT_TRUE(h5::read_text_attribute(provenance, "compiler"));
}

TEST_F(StudyFile, HasEqualBytesForEqualContentAndOthersForOther) {
  write_study_file(path_, kHead, some_tables());
  write_study_file(folder_.at("again.h5"), kHead, some_tables());
  EXPECT_EQ(bytes_of(path_), bytes_of(folder_.at("again.h5")));
  std::vector<Table> others = some_tables();
  std::get<std::vector<double>>(others[0].columns[0].values)[1] = 2.25;
  write_study_file(folder_.at("other.h5"), kHead, others);
  EXPECT_NE(bytes_of(path_), bytes_of(folder_.at("other.h5")));
}

TEST_F(StudyFile, IsCompleteOrMissing) {
  EXPECT_THROW(write_study_file(folder_.at("none/study.h5"), kHead, some_tables()), Failure);
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace hyrax

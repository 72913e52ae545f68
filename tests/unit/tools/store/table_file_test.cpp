#include <gtest/gtest.h>

#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"
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

// What is in the file is in outputs.md and in tests of the command.
TEST(StudyTables, HaveEqualBytesForEqualContentAlone) {
  const TempFolder folder;
  const std::string path = folder.at("study.h5"), other = folder.at("other.h5");
  write_study_file(path, kHead, some_tables());
  EXPECT_EQ(format_of_file(path), kStudyFormat);
  std::vector<Table> others = some_tables();
  for (const double changed : {2.5, 2.25}) {
    std::get<std::vector<double>>(others[0].columns[0].values)[1] = changed;
    write_study_file(other, kHead, others);
    EXPECT_EQ(bytes_of(path) == bytes_of(other), changed == 2.5);
  }
}

TEST(FormatOfFile, IsEmptyOfWhatHasNone) {
  const TempFolder folder;
  write_bytes(folder.at("text.h5"), "no HDF5");
  EXPECT_EQ(format_of_file(folder.at("text.h5")), "");
  EXPECT_THROW(static_cast<void>(format_of_file(folder.at("none.h5"))), Failure);
}

}  // namespace
}  // namespace hyrax

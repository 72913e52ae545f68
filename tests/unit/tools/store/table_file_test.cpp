#include <gtest/gtest.h>

#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
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

h5::Handle text_type(std::size_t width) {
  h5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  EXPECT_GE(H5Tset_size(type, width), 0);
  return type;
}

class StudyTables : public testing::Test {
 protected:
  // The tables, with another column of that name and without values.
  void write_with_column(const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                         hid_t creation = H5P_DEFAULT) const {
    write_study_file(path_, kHead, some_tables());
    const h5::Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    ASSERT_GE(H5Ldelete(file, name.c_str(), H5P_DEFAULT), 0);
    const h5::Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    const h5::Handle column(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                            H5Dclose);
    ASSERT_TRUE(column.is_open());
  }
  void expect_refused_with(const std::string& column, hid_t type, const std::vector<hsize_t>& shape,
                           const std::string& sentence, hid_t creation = H5P_DEFAULT) const {
    write_with_column(column, type, shape, creation);
    EXPECT_EQ(refusal(), path_ + ": " + column + ": " + sentence);
  }
  // Why the file is refused; empty if it is not.
  [[nodiscard]] std::string refusal() const {
    return refusal_of([&] { static_cast<void>(read_study_file(path_)); });
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("study.h5");
};

TEST_F(StudyTables, AreReadBackInTheirOrderAndHaveEqualBytesForEqualContentAlone) {
  write_study_file(path_, kHead, some_tables());
  const StudyFile study = read_study_file(path_);
  EXPECT_EQ(format_of_file(path_), kStudyFormat);
  EXPECT_EQ(study.head.study, kHead.study);
  EXPECT_EQ(study.head.long_name, kHead.long_name);
  EXPECT_TRUE(std::ranges::all_of(study.provenance, [](const auto& text) { return text.has_value(); }));
  ASSERT_EQ(study.tables.size(), 2u);
  for (std::size_t table = 0; table < 2; ++table)
    EXPECT_EQ(described(study.tables[table]), described(some_tables()[table]));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int64_t>>(study.tables[0].columns[1].values));
  std::vector<Table> others = some_tables();
  for (const double changed : {2.5, 2.25}) {
    std::get<std::vector<double>>(others[0].columns[0].values)[1] = changed;
    write_study_file(folder_.at("other.h5"), kHead, others);
    EXPECT_EQ(bytes_of(path_) == bytes_of(folder_.at("other.h5")), changed == 2.5);
  }
}

TEST_F(StudyTables, OfAnotherKindOrWithSomethingMissingAreRefused) {
  write_bytes(path_, "no HDF5");
  EXPECT_EQ(refusal(), path_ + ": is not an HDF5 file");
  h5::write_attribute(h5::create_file(path_, 1), "format", "hyrax-trajectory/1");
  EXPECT_EQ(refusal(), path_ + ": is no result file of a study (hyrax-study/1)");
  EXPECT_THROW(static_cast<void>(format_of_file(folder_.at("none.h5"))), Failure);
  for (const std::string object : {"first/rows", "empty"}) {
    write_study_file(path_, kHead, some_tables());
    ASSERT_GE(H5Ldelete(h5::open_file_to_write(path_), object.c_str(), H5P_DEFAULT), 0);
    EXPECT_EQ(refusal(), path_ + ": " + object + ": is missing");
  }
  write_study_file(path_, kHead, {});
  EXPECT_EQ(refusal(), path_ + ": names no tables: an older version wrote it; run the study again");
}

TEST_F(StudyTables, WithAColumnOfAnotherFormOrThatCannotBeReadAreRefused) {
  const std::string no_list = "is damaged: must be a list of at most 10000000 values";
  expect_refused_with("first/rows", H5T_STD_I64LE, {3}, "has another length than error");
  expect_refused_with("first/error", H5T_IEEE_F64LE, {2, 1}, no_list);
  expect_refused_with("first/error", H5T_IEEE_F64LE, {10'000'001}, no_list);

  const std::string unreadable = "is damaged: cannot be read";
  const h5::Handle elsewhere(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  ASSERT_GE(H5Pset_external(elsewhere, folder_.at("none.bin").c_str(), 0, H5F_UNLIMITED), 0);
  expect_refused_with("first/error", H5T_IEEE_F64LE, {2}, unreadable, elsewhere);
  expect_refused_with("first/rows", H5T_STD_I64LE, {2}, unreadable, elsewhere);
  expect_refused_with("first/method", text_type(3), {2}, unreadable, elsewhere);
  expect_refused_with("first/rows", H5T_STD_B8LE, {2}, unreadable);
  expect_refused_with("first/rows", text_type(H5T_VARIABLE), {2}, unreadable);

  constexpr std::size_t kMost = 64 << 20;  // Bytes of text in a column.
  write_with_column("empty/text", text_type(kMost / 2 + 1), {1});
  EXPECT_EQ(row_count(read_study_file(path_).tables.at(1)), 1u);
  expect_refused_with("empty/text", text_type(kMost + 1), {1}, unreadable);
  expect_refused_with("empty/text", text_type(kMost / 2 + 1), {2}, unreadable);
}

}  // namespace
}  // namespace hyrax

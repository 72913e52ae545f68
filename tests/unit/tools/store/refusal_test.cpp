// A damaged trajectory file is refused, with a message that names file and place.
#include <gtest/gtest.h>

#include "tests/unit/sim/compare/played_run.h"
#include "tests/unit/tools/store/stored_flings.h"
#include "tools/store/golden_file.h"

namespace hyrax {
namespace {

class Refusal : public testing::Test {
 protected:
  Refusal() {
    write_run(path_, eventful_fling());
    whole_ = bytes_of(path_);
  }

  // Opens the file for damage.
  h5::Handle open() const { return {H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose}; }

  void remove(const char* object) const { ASSERT_GE(H5Ldelete(open(), object, H5P_DEFAULT), 0) << object; }

  // Puts another dataset, of zeros, in the place of one of the undamaged file.
  void replace(const char* dataset, hid_t type, const std::vector<hsize_t>& shape) const {
    write_bytes(path_, whole_);
    remove(dataset);
    const h5::Handle file = open();
    const h5::Handle made = h5::create_dataset(file, dataset, type, shape);
    const std::vector<double> zeros(60'000);
    ASSERT_GE(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0) << dataset;
  }

  // Sets an element of a dataset of the undamaged file, which holds values of that type.
  template <class Value>
  void set(const char* dataset, hsize_t row, Value value) const {
    write_bytes(path_, whole_);
    const h5::Handle file = open();
    const h5::Handle numbers(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose);
    const h5::Handle type(H5Dget_type(numbers), H5Tclose);
    ASSERT_EQ(H5Tget_size(type), sizeof value);
    ASSERT_GE(h5::write_rows(numbers, type, row, 1, &value), 0);
  }

  void expect_refused(const std::string& sentence) const {
    const std::string said = refusal_of([&] { read_all(path_); });
    EXPECT_TRUE(said.starts_with(path_ + ": " + sentence)) << said << "\nis not: " << sentence;
  }
  void expect_refused_as_golden(const std::string& sentence) const {
    EXPECT_EQ(refusal_of([&] { static_cast<void>(read_golden(path_)); }), path_ + ": " + sentence);
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
  std::string whole_;
};

TEST_F(Refusal, OfAFileCutShortAtAnyLength) {
  const std::size_t stride = whole_.size() / 199;
  for (std::size_t length = 0; length < whole_.size(); length += stride) {
    write_bytes(path_, whole_.substr(0, length));
    EXPECT_NE(refusal_of([&] { read_all(path_); }), "") << length << " of " << whole_.size() << " bytes";
  }
  for (const std::size_t missing : {1u, 2u, 8u, 100u}) {
    write_bytes(path_, whole_.substr(0, whole_.size() - missing));
    EXPECT_NE(refusal_of([&] { read_all(path_); }), "") << "the last " << missing << " bytes are missing";
  }
}

TEST_F(Refusal, OfAFileOfAnotherKindAFolderAndAFileThatIsMissing) {
  for (const char* const text : {"step,t,x,y\n0,0,0,0\n", ""}) {
    write_bytes(path_, text);
    expect_refused("is not an HDF5 file, or is truncated");
  }
  ASSERT_TRUE(h5::create_file(path_, 0).is_open());
  expect_refused("attribute format: unknown format (found none); allowed: hyrax-trajectory/1");
  EXPECT_THROW(read_all(folder_.at("")), Failure);
  EXPECT_EQ(refusal_of([] { read_all("/no/such/run.h5"); }, ExitCode::cannot_access),
            "/no/such/run.h5: cannot be read: No such file or directory");
}

TEST_F(Refusal, OfAnAttributeThatIsMissingOrHasAnotherValue) {
  const auto with = [&](const std::string& sentence, const std::string& attribute, const auto&... value) {
    write_bytes(path_, whole_);
    ASSERT_GE(H5Adelete(open(), attribute.c_str()), 0);
    (h5::write_attribute(open(), attribute.c_str(), value), ...);
    expect_refused(sentence);
  };
  for (const std::string attribute : {"scenario", "physics", "state_hash"}) {
    with("attribute " + attribute + ": is missing or not text", attribute);
    with("attribute " + attribute + ": is missing or not text", attribute, std::int64_t{1});
  }
  with("attribute scenario: /name: is missing", "scenario", R"({"format": "hyrax-scenario/1"})");
  with("attribute format: unknown format (found none)", "format");
  with("attribute format: unknown format (found none)", "format", std::int64_t{1});
  with("attribute format: unknown format (found hyrax-trajectory/2)", "format", "hyrax-trajectory/2");
  const std::string no_steps = "attribute steps: is missing or not an integer 0 .. 1e12";
  with(no_steps, "steps");
  with(no_steps, "steps", "330");
  with(no_steps, "steps", std::int64_t{-1});
  with(no_steps, "steps", kStepsMax + 1);
  with("/trajectory/step: ends at the wrong row (found 330); the attribute steps is 331", "steps",
       std::int64_t{331});
}

TEST_F(Refusal, OfNoRowsAndOfContactsWithoutTotal) {
  ASSERT_GE(H5Adelete_by_name(open(), "/contacts", "total", H5P_DEFAULT), 0);
  expect_refused("/contacts: attribute total: is missing or not an integer");
  std::vector<std::pair<std::string, hid_t>> datasets = {{"step", H5T_STD_I64LE}, {"contact", H5T_STD_U8LE}};
  for (const RowColumn& column : kRowColumns) datasets.emplace_back(column.name, H5T_IEEE_F64LE);
  for (const auto& [name, type] : datasets) {
    remove(("/trajectory/" + name).c_str());
    static_cast<void>(h5::create_dataset(open(), ("/trajectory/" + name).c_str(), type, {0}));
  }
  expect_refused("/trajectory: has no rows");
}

TEST_F(Refusal, OfAMissingDatasetOrGroup) {
  std::vector<std::string> names = {"/trajectory",      "/contacts",           "/events",
                                    "/trajectory/step", "/trajectory/contact", "/events/frame",
                                    "/events/kind",     "/events/a",           "/events/b"};
  for (const RowColumn& column : kRowColumns) names.push_back(std::string("/trajectory/") + column.name);
  for (const ColumnOf<Contact>& column : kContactColumns)
    names.push_back(std::string("/contacts/") + column.name);
  for (const std::string& name : names) {
    write_bytes(path_, whole_);
    remove(name.c_str());
    expect_refused(std::ranges::count(name, '/') > 1 ? name + ": is missing" : name);
  }
}

TEST_F(Refusal, OfAWrongTypeOrLength) {
  const auto with = [&](const std::string& dataset, hid_t type, hsize_t length, const std::string& sentence) {
    replace(dataset.c_str(), type, {length});
    expect_refused(dataset + ": " + sentence);
  };
  const std::string wrong = "is of the wrong type", rows = "; /trajectory/step has 331";
  const std::string another = "differs in length from /contacts/step";
  with("/trajectory/x", H5T_IEEE_F32LE, 331, wrong);
  with("/trajectory/x", H5T_STD_I64LE, 331, wrong);
  with("/trajectory/step", H5T_IEEE_F64LE, 331, wrong);
  with("/trajectory/step", H5T_STD_I32LE, 331, wrong);
  with("/trajectory/contact", H5T_STD_I64LE, 331, wrong);
  with("/contacts/wall", H5T_IEEE_F64LE, 20, wrong);
  with("/events/kind", H5T_STD_U8LE, 14, wrong);
  with("/trajectory/x", H5T_IEEE_F64LE, 330, "has the wrong length (found 330)" + rows);
  with("/trajectory/vy", H5T_IEEE_F64LE, 332, "has the wrong length (found 332)" + rows);
  with("/trajectory/contact", H5T_STD_U8LE, 0, "has the wrong length (found 0)" + rows);
  with("/contacts/overshoot", H5T_IEEE_F64LE, 3, another);
  with("/contacts/last_step", H5T_STD_I64LE, 0, another);
  replace("/trajectory/step", H5T_STD_I64LE, {0});
  expect_refused("/trajectory/t: has the wrong length (found 331); /trajectory/step has 0");
  for (const char* const dataset : {"/events/a", "/events/b"}) {
    replace(dataset, H5T_IEEE_F64LE, {3});
    expect_refused("/events: its datasets differ in length");
  }
  replace("/trajectory/x", H5T_IEEE_F64LE, {331, 1});
  expect_refused("/trajectory/x: must have one axis");
  remove("/trajectory/x");
  static_cast<void>(h5::create_dataset(open(), "/trajectory/x", H5T_IEEE_F64LE, {331}));  // Without values.
  expect_refused("/trajectory/x: is incomplete");
}

TEST_F(Refusal, OfAWallOrAnInputThatIsNone) {
  set("/contacts/wall", 0, std::uint8_t{3});
  expect_refused("/contacts/wall: unknown code (found 3); allowed: 1, 2, 4, 8");
  set("/events/kind", 0, std::uint8_t{200});
  expect_refused("/events/kind: unknown code (found 200); allowed: 0 .. 7");
  set("/events/kind", 0, std::uint8_t{6});
  expect_refused("/events: input 0: its numbers do not fit its kind, grab");
}

TEST_F(Refusal, OfAGoldenFileWithHolesOrRowsOutOfOrder) {
  set("/trajectory/step", 5, std::int64_t{7});
  expect_refused_as_golden("/trajectory/step: row 5 is missing or out of order (found 7)");
  Scenario scenario = fling_at(60.0, 100);
  scenario.record_every = 10;
  write_run(path_, scenario);
  expect_refused_as_golden("not written by bless: has no blocks, and 11 rows of 101");
}

// The golden file of a run of three blocks.
class BlockRefusal : public Refusal {
 protected:
  BlockRefusal() {
    AtomicFile target(path_);
    write_golden(target, path_, kept_run(fling_at(60.0, kSteps)));
    target.commit();
    whole_ = bytes_of(path_);
  }

  void expect_refused_with(const char* dataset, hid_t type, std::int64_t length,
                           const std::string& sentence) {
    replace(dataset, type, {static_cast<hsize_t>(length)});
    expect_refused_as_golden(sentence);
  }

  static constexpr std::int64_t kSteps = 2 * static_cast<std::int64_t>(kBlockRows) + 99;
};

TEST_F(BlockRefusal, OfLengthsThatDiffer) {
  const std::string differ = "/blocks: its datasets differ in length";
  for (const std::int64_t blocks : {0, 4}) {
    expect_refused_with("/blocks/count", H5T_STD_I64LE, blocks, differ);
    expect_refused_with("/blocks/time_base", H5T_IEEE_F64LE, blocks, differ);
    expect_refused_with("/blocks/is_held", H5T_IEEE_F64LE, blocks, differ);
    expect_refused_with("/blocks/digest", H5T_STD_U8LE, blocks * 16, differ);
  }
  constexpr std::int64_t kChecks = (kSteps + 1) * static_cast<std::int64_t>(sizeof(RowCheck));
  for (const std::int64_t missing : {std::int64_t{1}, std::int64_t{sizeof(RowCheck)}, kChecks})
    expect_refused_with("/blocks/row_check", H5T_STD_U8LE, kChecks - missing,
                        "/blocks/row_check: is too short");
  for (const std::int64_t more : {1, 6})
    expect_refused_with("/blocks/row_check", H5T_STD_U8LE, kChecks + more, "/blocks/row_check: is too long");
}

TEST_F(BlockRefusal, OfBlocksThatAreNotConsecutive) {
  expect_refused_with("/blocks/count", H5T_STD_I64LE, 3, "/blocks: are not consecutive");
  set("/trajectory/step", 1, std::int64_t{4095});
  expect_refused_as_golden("/blocks: are not consecutive");
  set("/blocks/count", 2, std::int64_t{2});
  expect_refused_as_golden("/blocks/count: its blocks do not end with the run's last row");
}

TEST_F(BlockRefusal, OfAStateThatNoReplayHas) {
  for (const auto& [name, value] : {std::pair{"time_frames", -1.0},
                                    {"time_frames", 1e13},
                                    {"window_width", 1e7},
                                    {"window_height", -1.0},
                                    {"sprite_width", 64.5},
                                    {"is_held", 2.0}}) {
    const std::string dataset = std::string("/blocks/") + name;
    set(dataset.c_str(), 1, value);
    expect_refused_as_golden(dataset + ": not a state of a replay (found " + std::to_string(value) + ")");
  }
}

}  // namespace
}  // namespace hyrax

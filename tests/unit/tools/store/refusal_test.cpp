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

  // Sets the first element of a dataset of bytes.
  void set_first(const char* dataset, std::uint8_t value) const {
    const h5::Handle file = open();
    const h5::Handle bytes(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose);
    const h5::Handle type(H5Dget_type(bytes), H5Tclose);
    ASSERT_GE(h5::write_rows(bytes, type, 0, 1, &value), 0);
  }

  void expect_refused(const std::string& place) const {
    const std::string sentence = refusal_of([&] { read_all(path_); });
    EXPECT_EQ(sentence.rfind(path_ + ": ", 0), 0u) << sentence;
    EXPECT_NE(sentence.find(place), std::string::npos) << sentence << "\nshould name " << place;
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
  std::string whole_;
};

TEST_F(Refusal, DoesNotOccurForACompleteFile) {
  EXPECT_EQ(refusal_of([&] { read_all(path_); }), "");
}

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

TEST_F(Refusal, OfAFileOfAnotherKind) {
  for (const char* const text : {"step,t,x,y\n0,0,0,0\n", ""}) {
    write_bytes(path_, text);
    expect_refused("HDF5");
  }
  ASSERT_TRUE(h5::create_file(path_, 0).is_open());
  expect_refused("unknown format (found none)");
}

TEST_F(Refusal, OfAMissingAttribute) {
  for (const std::string attribute : {"scenario", "steps", "physics", "state_hash", "format"}) {
    write_bytes(path_, whole_);
    ASSERT_GE(H5Adelete(open(), attribute.c_str()), 0);
    expect_refused(attribute == "format" ? "none" : attribute);
  }
}

TEST_F(Refusal, OfAnAttributeOfAnotherValue) {
  const auto with = [&](const char* attribute, auto value, const char* place) {
    write_bytes(path_, whole_);
    H5Adelete(open(), attribute);
    h5::write_attribute(open(), attribute, value);
    expect_refused(place);
  };
  with("format", "hyrax-trajectory/2", "hyrax-trajectory/2");
  with("scenario", R"({"format": "hyrax-scenario/1"})", "attribute scenario");
  with("steps", std::int64_t{331}, "331");
  for (const char* const attribute : {"scenario", "physics", "state_hash"})
    with(attribute, std::int64_t{1}, attribute);
  with("format", std::int64_t{1}, "none");
  with("steps", "330", "steps");
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
    expect_refused(name);
  }
}

TEST_F(Refusal, OfAWrongTypeOrLength) {
  const auto with = [&](const char* dataset, hid_t type, hsize_t length, const char* place = nullptr) {
    replace(dataset, type, {length});
    expect_refused(place == nullptr ? dataset : place);
  };
  with("/trajectory/x", H5T_IEEE_F32LE, 331);
  with("/trajectory/x", H5T_STD_I64LE, 331);
  with("/trajectory/step", H5T_IEEE_F64LE, 331);
  with("/trajectory/step", H5T_STD_I32LE, 331);
  with("/trajectory/contact", H5T_STD_I64LE, 331);
  with("/contacts/wall", H5T_IEEE_F64LE, 20);
  with("/events/kind", H5T_STD_U8LE, 14);
  with("/trajectory/x", H5T_IEEE_F64LE, 330);
  with("/trajectory/step", H5T_STD_I64LE, 0, "/trajectory");
  with("/trajectory/vy", H5T_IEEE_F64LE, 332);
  with("/trajectory/contact", H5T_STD_U8LE, 0);
  with("/contacts/overshoot", H5T_IEEE_F64LE, 3);
  with("/contacts/last_step", H5T_STD_I64LE, 0);
  with("/events/b", H5T_IEEE_F64LE, 3, "/events");
  replace("/trajectory/x", H5T_IEEE_F64LE, {331, 1});
  expect_refused("/trajectory/x");
}

TEST_F(Refusal, OfAWallOrAnInputThatIsNone) {
  for (const auto& [dataset, value] : {std::pair{"/contacts/wall", 3}, {"/events/kind", 200}}) {
    write_bytes(path_, whole_);
    set_first(dataset, static_cast<std::uint8_t>(value));
    expect_refused(dataset);
  }
}

TEST_F(Refusal, OfARunWithHolesAsGoldenFile) {
  Scenario scenario = fling_at(60.0, 100);
  scenario.record_every = 10;
  write_run(path_, scenario);
  const std::string sentence = refusal_of([&] { static_cast<void>(read_golden(path_)); });
  EXPECT_NE(sentence.find("11 rows of 101"), std::string::npos) << sentence;
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
    EXPECT_EQ(refusal_of([&] { static_cast<void>(read_golden(path_)); }), path_ + ": " + sentence);
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
}

TEST(Reading, AMissingFileCannotBeAccessed) {
  EXPECT_EQ(refusal_of([] { read_all("/no/such/run.h5"); }, ExitCode::cannot_access),
            "/no/such/run.h5: cannot be read: No such file or directory");
}

TEST(Reading, AFolderIsNoTrajectory) {
  const TempFolder folder;
  EXPECT_THROW(read_all(folder.at("")), Failure);
}

}  // namespace
}  // namespace hyrax

// A damaged trajectory or golden file is refused, with a message that names file and place: those approved.
#include <gtest/gtest.h>

#include "tests/unit/sim/compare/played_run.h"
#include "tests/unit/sim/result/described.h"
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

  void remove(const std::string& object) const {
    ASSERT_GE(H5Ldelete(open(), object.c_str(), H5P_DEFAULT), 0) << object;
  }

  // What is said of the file after this damage.
  void add(const std::string& damage, const auto& read) {
    std::string said = refusal_of([&] { read(path_); });
    ASSERT_TRUE(said.starts_with(path_ + ": ")) << damage << ": " << said;
    for (std::size_t at; (at = said.find(path_)) != said.npos;) said.erase(at, path_.size());
    text_ += damage + said + "\n";
  }
  void add(const std::string& damage) { add(damage, read_all); }
  void add_golden(const std::string& damage) { add(damage, read_golden); }

  // Puts another dataset, of zeros, in the place of one of the undamaged file.
  std::string replace(const std::string& dataset, hid_t type, const std::vector<hsize_t>& shape) const {
    write_bytes(path_, whole_);
    remove(dataset);
    const h5::Handle file = open();
    const h5::Handle made = h5::create_dataset(file, dataset.c_str(), type, shape);
    const std::vector<double> zeros(60'000);
    EXPECT_GE(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0) << dataset;
    return dataset + " of " + std::to_string(shape[0]);
  }

  // Sets an element of a dataset of the undamaged file, which holds values of that type.
  template <class Value>
  std::string set(const std::string& dataset, hsize_t row, Value value) const {
    write_bytes(path_, whole_);
    const h5::Handle file = open();
    const h5::Handle numbers(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    const h5::Handle type(H5Dget_type(numbers), H5Tclose);
    EXPECT_EQ(H5Tget_size(type), sizeof value);
    EXPECT_GE(h5::write_rows(numbers, type, row, 1, &value), 0);
    return dataset + " " + std::to_string(row) + " = " + std::to_string(value);
  }

  const TempFolder folder_;
  const std::string path_ = folder_.at("run.h5");
  std::string whole_, text_;
};

TEST_F(Refusal, OfAFileCutShortAtAnyLength) {
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length < whole_.size(); length += whole_.size() / 199)
    lengths.push_back(length);
  for (const std::size_t missing : {1u, 2u, 8u, 100u}) lengths.push_back(whole_.size() - missing);
  for (const std::size_t length : lengths) {
    write_bytes(path_, whole_.substr(0, length));
    EXPECT_NE(refusal_of([&] { read_all(path_); }), "") << length << " of " << whole_.size() << " bytes";
  }
}

TEST_F(Refusal, OfADamagedTrajectoryFileIsThatApproved) {
  for (const char* const text : {"step,t,x,y\n0,0,0,0\n", ""}) {
    write_bytes(path_, text);
    add("no HDF5");
  }
  ASSERT_TRUE(h5::create_file(path_, 0).is_open());
  add("an empty HDF5 file");

  const auto with = [&](const std::string& attribute, const auto&... value) {
    write_bytes(path_, whole_);
    ASSERT_GE(H5Adelete(open(), attribute.c_str()), 0);
    (h5::write_attribute(open(), attribute.c_str(), value), ...);
    add("attribute " + attribute);
  };
  for (const std::string attribute : {"scenario", "physics", "state_hash", "format", "steps"})
    with(attribute);
  for (const std::string attribute : {"scenario", "physics", "state_hash", "format"})
    with(attribute, std::int64_t{1});
  with("scenario", R"({"format": "hyrax-scenario/1"})");
  with("format", "hyrax-trajectory/2");
  with("steps", "330");
  for (const std::int64_t steps : {std::int64_t{-1}, kStepsMax + 1, std::int64_t{331}}) with("steps", steps);

  std::vector<std::pair<std::string, hid_t>> rows = {{"step", H5T_STD_I64LE}, {"contact", H5T_STD_U8LE}};
  for (const RowColumn& column : kRowColumns) rows.emplace_back(column.name, H5T_IEEE_F64LE);
  std::vector<std::string> names = {"/trajectory",  "/contacts", "/events",  "/events/frame",
                                    "/events/kind", "/events/a", "/events/b"};
  for (const auto& [name, type] : rows) names.push_back("/trajectory/" + name);
  for (const ColumnOf<Contact>& column : kContactColumns)
    names.push_back(std::string("/contacts/") + column.name);
  for (const std::string& name : names) {
    write_bytes(path_, whole_);
    remove(name);
    add("without " + name);
  }
  write_bytes(path_, whole_);
  ASSERT_GE(H5Adelete_by_name(open(), "/contacts", "total", H5P_DEFAULT), 0);
  add("without the total of contacts");
  for (const auto& [name, type] : rows) {
    remove("/trajectory/" + name);
    static_cast<void>(h5::create_dataset(open(), ("/trajectory/" + name).c_str(), type, {0}));
  }
  add("without rows");

  for (const auto& [dataset, type, length] : std::initializer_list<std::tuple<const char*, hid_t, hsize_t>>{
           {"/trajectory/x", H5T_IEEE_F32LE, 331},
           {"/trajectory/x", H5T_STD_I64LE, 331},
           {"/trajectory/step", H5T_IEEE_F64LE, 331},
           {"/trajectory/step", H5T_STD_I32LE, 331},
           {"/trajectory/contact", H5T_STD_I64LE, 331},
           {"/contacts/wall", H5T_IEEE_F64LE, 20},
           {"/events/kind", H5T_STD_U8LE, 14},
           {"/trajectory/x", H5T_IEEE_F64LE, 330},
           {"/trajectory/vy", H5T_IEEE_F64LE, 332},
           {"/trajectory/contact", H5T_STD_U8LE, 0},
           {"/contacts/overshoot", H5T_IEEE_F64LE, 3},
           {"/contacts/last_step", H5T_STD_I64LE, 0},
           {"/trajectory/step", H5T_STD_I64LE, 0},
           {"/events/a", H5T_IEEE_F64LE, 3},
           {"/events/b", H5T_IEEE_F64LE, 3}})
    add(replace(dataset, type, {length}));
  add("of two axes, " + replace("/trajectory/x", H5T_IEEE_F64LE, {331, 1}));
  remove("/trajectory/x");
  static_cast<void>(h5::create_dataset(open(), "/trajectory/x", H5T_IEEE_F64LE, {331}));
  add("/trajectory/x without values");

  add(set("/contacts/wall", 0, std::uint8_t{3}));
  for (const int kind : {200, 6}) add(set("/events/kind", 0, static_cast<std::uint8_t>(kind)));
  {
    write_bytes(path_, whole_);
    const std::vector<std::int8_t> negative(TrajectoryFile::open(path_).inputs().size(), -1);
    remove("/events/kind");
    const h5::Handle file = open();
    const h5::Handle codes(H5Tenum_create(H5T_STD_I8LE), H5Tclose);
    ASSERT_GE(H5Tenum_insert(codes, "negative", negative.data()), 0);
    const h5::Handle kinds = h5::create_dataset(file, "/events/kind", codes, {negative.size()});
    ASSERT_GE(h5::write_rows(kinds, codes, 0, negative.size(), negative.data()), 0);
  }
  add("/events/kind of negative codes");
  expect_approved("tests/unit/tools/store/refused_trajectories.txt", text_);
}

TEST_F(Refusal, OfADamagedGoldenFileIsThatApproved) {
  add_golden(set("/trajectory/step", 5, std::int64_t{7}));
  Scenario scenario = fling_at(60.0, 100);
  scenario.record_every = 10;
  write_run(path_, scenario);
  add_golden("every tenth row");

  constexpr std::int64_t kSteps = 2 * static_cast<std::int64_t>(kBlockRows) + 99;
  AtomicFile target(path_);
  write_golden(target, path_, kept_run(fling_at(60.0, kSteps)));
  target.commit();
  whole_ = bytes_of(path_);
  constexpr hsize_t kChecks = (kSteps + 1) * sizeof(RowCheck);
  for (const hsize_t blocks : {hsize_t{0}, hsize_t{4}}) {
    add_golden(replace("/blocks/count", H5T_STD_I64LE, {blocks}));
    add_golden(replace("/blocks/time_base", H5T_IEEE_F64LE, {blocks}));
    add_golden(replace("/blocks/is_held", H5T_IEEE_F64LE, {blocks}));
    add_golden(replace("/blocks/digest", H5T_STD_U8LE, {blocks * 16}));
  }
  for (const hsize_t bytes : {kChecks - 1, kChecks - sizeof(RowCheck), hsize_t{0}, kChecks + 1, kChecks + 6})
    add_golden(replace("/blocks/row_check", H5T_STD_U8LE, {bytes}));
  add_golden(replace("/blocks/count", H5T_STD_I64LE, {3}));
  add_golden(set("/trajectory/step", 1, std::int64_t{4095}));
  add_golden(set("/blocks/count", 2, std::int64_t{2}));
  // States that no replay has.
  for (const auto& [name, value] : {std::pair{"time_frames", -1.0},
                                    {"time_frames", 1e13},
                                    {"window_width", 1e7},
                                    {"window_height", -1.0},
                                    {"sprite_width", 64.5},
                                    {"is_held", 2.0}})
    add_golden(set(std::string("/blocks/") + name, 1, value));
  expect_approved("tests/unit/tools/store/refused_goldens.txt", text_);
}

}  // namespace
}  // namespace hyrax

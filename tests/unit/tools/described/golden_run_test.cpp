// Trajectory and golden files of a core that describes itself.
#include "tools/described/golden_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "sim/described/see.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/described/scenario_json.h"
#include "tools/files/failure.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

enum class Mood : std::int8_t { wild = 0, calm = 1 };

double push_px_per_s2 = 3.0;  // Of every body that is made from now on.

struct Marble {
  double x_px = 1.0;
  double y_px = 2.0;
  float spin = 0.1F;
  std::uint8_t small = 250;
  std::int64_t large = -(std::int64_t{1} << 62) - 1;
  std::uint64_t huge = ~std::uint64_t{0};
  bool on = true;
  Mood mood = Mood::calm;
  double push = push_px_per_s2;
  double width_px = 100.0;
  bool wall = false;

  void step(double dt_s) {
    x_px += push * dt_s;
    ++small;
    on = !on;
    spin *= 0.75F;
    wall = small == 3 || small == 4;
    mood = wall ? Mood::wild : Mood::calm;
  }
  void state(auto&& see) {
    see("x_px", x_px);
    see("y_px", y_px);
    see("spin", spin);
    see("small", small);
    see("large", large);
    see("huge", huge);
    see("on", on);
    see("mood", mood, {"wild", "calm"});
  }
  void inputs(auto&& see) { see("width_px", width_px); }
  void actions(auto&& see) {
    see("put", [&](double at_px) { y_px = at_px; }, {"at_px"});
  }
  void contacts(auto&& see) const { see("wall", wall); }
  void outputs(auto&& see) const { see("twice_px", 2.0 * x_px); }
};

const DescribedCore& marble() {
  static const DescribedCore core = described_core_of<Marble>("marble", {.header = "of the test"});
  return core;
}

DescribedScenario scenario_of(std::int64_t steps) {
  DescribedScenario scenario;
  scenario.name = "roll";
  scenario.clock.base = FixedRate{60.0};
  scenario.length = steps;
  scenario.events = {{std::int64_t{2}, Act{0, {word_of(7.5)}}}};
  return scenario;
}

class DescribedFiles : public ::testing::Test {
 protected:
  // Writes a run, and returns its rows.
  DescribedRows write(const std::string& path, std::int64_t steps) {
    DescribedWriter writer(path, path, marble().description, steps, 1);
    const DescribedScenario scenario = scenario_of(steps);
    const GoldenContents run = play_for_golden(marble(), scenario, {&writer});
    writer.finish({{.steps = steps,
                    .physics = std::string(kDescribedModel),
                    .state_hash = run.state_hash(),
                    .core = "abc"},
                   marble().description,
                   scenario},
                  run.contacts_total());
    return run.rows;
  }
  [[nodiscard]] GoldenPlace place() const {
    return {.h5_path = folder_.at("golden/roll.h5"), .txt_path = folder_.at("golden/roll.txt")};
  }
  [[nodiscard]] GoldenComparison compare(const DescribedScenario& scenario) const {
    return compare_with_golden(marble(), scenario, play_for_golden(marble(), scenario), place());
  }
  void TearDown() override { push_px_per_s2 = 3.0; }

  TempFolder folder_;
};

DescribedRows all_of(const DescribedFile& file) {
  DescribedRows rows;
  for (CursorOf<DescribedRows> cursor(file.rows()); !cursor.is_done(); cursor.next())
    rows.append(cursor.row());
  return rows;
}

std::string sentence_of(const auto& work) {
  try {
    work();
    return "";
  } catch (const Failure& failure) {
    return failure.what();
  }
}

TEST_F(DescribedFiles, AreReadBackAsTheyWereWritten) {
  const std::string path = folder_.at("roll.h5");
  const DescribedRows rows = write(path, 20);
  const DescribedFile file = DescribedFile::open(path, "marble");
  EXPECT_TRUE(description_difference(file.head().description, marble().description).empty());
  EXPECT_EQ(to_text(description_json(file.head().description)),
            to_text(description_json(marble().description)));
  EXPECT_TRUE(plays_the_same(file.head().scenario, scenario_of(20)));
  EXPECT_EQ(file.head().core, "abc");
  const DescribedRows read = all_of(file);
  EXPECT_EQ(read.step, rows.step);
  EXPECT_EQ(read.t_s, rows.t_s);
  EXPECT_EQ(read.dt_s, rows.dt_s);
  EXPECT_EQ(read.state, rows.state);
  EXPECT_EQ(read.contacts, rows.contacts);
  const std::vector<DescribedContact> contacts = file.contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].step, 9);
  EXPECT_EQ(contacts[0].last_step, 10);
  EXPECT_EQ(file.contacts_total(), 1);
}

TEST_F(DescribedFiles, HaveTheValuesOwnTypes) {
  const std::string path = folder_.at("roll.h5");
  write(path, 3);
  const h5::Handle file = h5::open_file(path);
  const auto is_of = [&](const char* name, hid_t expected) {
    const h5::Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const h5::Handle type(H5Dget_type(dataset), H5Tclose);
    return H5Tequal(type, expected) > 0;
  };
  EXPECT_TRUE(is_of("/trajectory/x_px", H5T_IEEE_F64LE));
  EXPECT_TRUE(is_of("/trajectory/spin", H5T_IEEE_F32LE));
  EXPECT_TRUE(is_of("/trajectory/small", H5T_STD_U8LE));
  EXPECT_TRUE(is_of("/trajectory/large", H5T_STD_I64LE));
  EXPECT_TRUE(is_of("/trajectory/huge", H5T_STD_U64LE));
  EXPECT_TRUE(is_of("/trajectory/on", H5T_STD_U8LE));
  EXPECT_TRUE(is_of("/trajectory/wall", H5T_STD_U8LE));
  EXPECT_TRUE(is_of("/trajectory/twice_px", H5T_IEEE_F64LE));
  const h5::Handle mood(H5Dopen2(file, "/trajectory/mood", H5P_DEFAULT), H5Dclose);
  const h5::Handle type(H5Dget_type(mood), H5Tclose);
  EXPECT_EQ(H5Tget_class(type), H5T_ENUM);
  EXPECT_EQ(H5Tget_size(type), 1U);
}

TEST_F(DescribedFiles, AreRefusedWhereTheyAreOfAnotherCoreOrDamaged) {
  const std::string path = folder_.at("roll.h5");
  write(path, 20);
  const auto open = [&] { static_cast<void>(DescribedFile::open(path, "pool")); };
  EXPECT_EQ(sentence_of(open), path + ": is of the core marble: read it with marble-sim");
  EXPECT_EQ(sentence_of([&] { static_cast<void>(TrajectoryFile::open(path)); }),
            path + ": is of the core marble, which describes itself: read it with marble-sim");
  const auto bytes = std::filesystem::file_size(path);
  for (std::uintmax_t size = 0; size < bytes; size += bytes / 16) {
    std::filesystem::resize_file(path, bytes - size - 1);
    EXPECT_NE(sentence_of([&] { static_cast<void>(DescribedFile::open(path, "marble").contacts()); }), "")
        << size;
  }
}

TEST_F(DescribedFiles, CsvHasNumbers) {
  const std::string path = folder_.at("roll.csv");
  DescribedCsv csv(path, marble().description, 1, 1);
  const DescribedScenario scenario = scenario_of(3);
  DescribedScenario short_scenario = scenario;
  short_scenario.length = std::int64_t{1};
  short_scenario.events.clear();
  static_cast<void>(play_for_golden(marble(), short_scenario, {&csv}));
  csv.finish();
  EXPECT_EQ(read_text_file(path),
            "step,t_s,dt_s,x_px,y_px,spin,small,large,huge,on,mood,wall,twice_px\n"
            "0,0,0,1,2,0.1,250,-4611686018427387905,18446744073709551615,1,1,0,2\n"
            "1,0.016666666666666666,0.016666666666666666,1.05,2,0.075,251,-4611686018427387905,"
            "18446744073709551615,0,1,0,2.1\n");
}

TEST_F(DescribedFiles, AGoldenPairProvesThatARunAgrees) {
  const DescribedScenario scenario = scenario_of(90);
  write_golden_pair(marble(), scenario, place(), "first");
  EXPECT_TRUE(compare(scenario).is_proved);
  const std::string summary = read_text_file(place().txt_path);
  for (const char* const part :
       {"scenario: roll\nphysics: hyrax-core/1\ncore: marble\nsteps: 90\nstate hash: ",
        "\ncontacts: wall 1\n  9 .. 10 wall\n", "\nposition:\n  1 s  x 4.000000 px, y 7.500000 px  step 60\n",
        "\n  small 84\n", "\n  mood calm\n", "\nreason: first\n"})
    EXPECT_NE(summary.find(part), std::string::npos) << part << summary;
}

TEST_F(DescribedFiles, ASummaryHasTheLastRowUpToEachSecond) {
  DescribedScenario scenario = scenario_of(90);
  scenario.events.push_back({std::int64_t{70}, Hitch{2.0}});
  write_golden_pair(marble(), scenario, place(), "first");
  const std::string summary = read_text_file(place().txt_path);
  EXPECT_NE(summary.find("y 7.500000 px  step 60\n  2 s  x 4.500000 px, y 7.500000 px  step 70\n"
                         "  3 s  x 4.500000 px, y 7.500000 px  step 70\nend:"),
            std::string::npos)
      << summary;
}

TEST_F(DescribedFiles, AnotherCoreDiffersFromTheGoldenFile) {
  const DescribedScenario scenario = scenario_of(90);
  write_golden_pair(marble(), scenario, place(), "first");
  push_px_per_s2 = 3.6;
  const GoldenComparison comparison = compare(scenario);
  EXPECT_EQ(comparison.difference, DifferenceClass::values);
  EXPECT_TRUE(comparison.fault.empty()) << comparison.fault;
  EXPECT_NEAR(*comparison.max_px(), 0.9, 1e-9);
  EXPECT_EQ(comparison.first->step, 1);
}

TEST_F(DescribedFiles, AnotherScenarioIsAnotherShape) {
  write_golden_pair(marble(), scenario_of(90), place(), "first");
  DescribedScenario other = scenario_of(90);
  other.events.clear();
  const GoldenComparison comparison = compare(other);
  EXPECT_TRUE(comparison.has_other_scenario);
  EXPECT_EQ(comparison.difference, DifferenceClass::shape);
  EXPECT_EQ(
      comparison.shape,
      "the scenario changed since it was blessed: /events [{ \"step\": 2, \"put\": { \"at_px\": 7.5 } }] "
      "-> none");
  EXPECT_EQ(comparison.max_px(), 5.5);
}

// Has an output more.
struct Painted : Marble {
  void outputs(auto&& see) const {
    Marble::outputs(see);
    see("hue", 1);
  }
};

TEST_F(DescribedFiles, WhatMovedIsSaidWhereTheDescriptionIsAnother) {
  const DescribedCore painted = described_core_of<Painted>("marble", {.header = "of the test"});
  for (const std::int64_t steps : {90, 3000}) {  // The golden file holds all rows, or blocks.
    write_golden_pair(marble(), scenario_of(steps), place(), "first");
    const auto compare_painted = [&] {
      return compare_with_golden(painted, scenario_of(steps),
                                 play_for_golden(painted, scenario_of(steps), {}), place());
    };
    const GoldenComparison same = compare_painted();
    EXPECT_EQ(same.shape, "output hue was added: bless --accept shape");
    EXPECT_EQ(same.max_px(), steps == 90 ? std::optional(0.0) : std::nullopt);
    push_px_per_s2 = 4.0;
    const GoldenComparison moved = compare_painted();
    push_px_per_s2 = 3.0;
    EXPECT_EQ(moved.difference, DifferenceClass::shape);
    if (steps == 90) {
      EXPECT_NEAR(*moved.max_px(), 1.5, 1e-9);
    }
    EXPECT_EQ(moved.distance.has_unknown_rows, steps != 90);
  }
}

TEST_F(DescribedFiles, AnEditedGoldenFileIsNoticed) {
  const DescribedScenario scenario = scenario_of(90);
  write_golden_pair(marble(), scenario, place(), "first");
  {
    const h5::Handle file(H5Fopen(place().h5_path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    const h5::Handle dataset(H5Dopen2(file, "/trajectory/y_px", H5P_DEFAULT), H5Dclose);
    const double y_px = 8.0;
    ASSERT_GE(h5::write_rows(dataset, H5T_NATIVE_DOUBLE, 4, 1, &y_px), 0);
  }
  EXPECT_TRUE(compare(scenario).fault.starts_with("the golden file was changed since it was blessed: "));
  write_golden_pair(marble(), scenario, place(), "again");
  std::string summary = read_text_file(place().txt_path);
  summary.replace(summary.find("wall 1"), 6, "wall 2");
  write_text_file(place().txt_path, summary);
  EXPECT_TRUE(compare(scenario).fault.starts_with("the golden file was changed since it was blessed: "));
}

TEST_F(DescribedFiles, LongRunsKeepBlocks) {
  const DescribedScenario scenario = scenario_of(9000);
  write_golden_pair(marble(), scenario, place(), "first");
  EXPECT_LT(std::filesystem::file_size(place().h5_path), 50'000U);
  EXPECT_TRUE(compare(scenario).is_proved);
  const DescribedFile file = DescribedFile::open(place().h5_path, "marble");
  EXPECT_EQ(all_of(file).step, (std::vector<std::int64_t>{0, 4096, 8192, 9000}));
  const std::vector<DescribedBlock> blocks = file.blocks(),
                                    played = play_for_golden(marble(), scenario).blocks;
  ASSERT_EQ(blocks.size(), 3U);
  for (std::size_t index = 0; index < blocks.size(); ++index) {
    EXPECT_EQ(blocks[index].digest, played[index].digest);
    EXPECT_EQ(blocks[index].keyframe, played[index].keyframe);
  }
  DescribedScenario other = scenario;
  other.events.clear();
  EXPECT_EQ(compare(other).max_px(), 5.5) << "both scenarios are played again";
  push_px_per_s2 = 3.6;
  const GoldenComparison comparison = compare(scenario);
  EXPECT_EQ(comparison.difference, DifferenceClass::values);
  EXPECT_FALSE(comparison.max_px());
  EXPECT_EQ(comparison.first->step, 0);
}

}  // namespace
}  // namespace hyrax

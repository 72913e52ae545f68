// Sweeps of a core that describes itself: what varies, what is kept, and what the file has of it.
#include <gtest/gtest.h>

#include <bit>

#include "sim/described/described_run.h"
#include "sim/described/see.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/described/commands.h"
#include "tools/described/scenario_json.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

enum class SweptMood : std::int8_t { calm, wild };

struct Toy {
  double x = 1.0;
  float charge = 0.5F;
  std::int16_t hits = -2;
  std::uint64_t ticks = 0;
  bool hot = false;
  SweptMood mood = SweptMood::calm;
  double push = 0.0;

  void step(double dt_s) {
    x += (push - x) * dt_s;
    charge *= 0.75F;
    ++hits, ++ticks;
    hot = hits > 0;
    mood = hot ? SweptMood::wild : mood;
    if (x > 90.0) throw std::runtime_error("off the table");
  }
  void state(auto&& see) {
    see("x_px", x);
    see("charge", charge, {-1.0, 1.0});
    see("hits", hits);
    see("ticks", ticks);
    see("hot", hot);
    see("mood", mood, {"calm", "wild"});
  }
  void inputs(auto&& see) { see("push", push); }
  void contacts(auto&& see) const { see("heat", hot); }
};

class DescribedSweep : public testing::Test {
 protected:
  std::string write(const std::string& vary, const std::string& more = "",
                    const std::string& clock = R"({"rate_hz": 60})") {
    std::string path = folder_.at("toy.json");
    write_text_file(path,
                    R"({"format": "hyrax-sweep/1", "members": 12, "seed": 3, "vary": {)" + vary +
                        R"(}, "keep": ["final", "contacts", "at_rest", "extremes", "state_hash"], "base":
        {"format": "hyrax-scenario/1", "steps": 5, "start": {"ticks": 7}, "clock": )" +
                        clock + more + "}}");
    return path;
  }
  PlayableSweep load(const std::string& vary, const std::string& more = "") {
    return swept_.load(write(vary, more));
  }
  std::string refusal(const std::string& vary, const std::string& more = "",
                      const std::string& clock = R"({"rate_hz": 60})") {
    const std::string path = write(vary, more, clock);
    std::string said = refusal_of([&] { static_cast<void>(swept_.load(path)); });
    return said.starts_with(path) ? said.substr(path.size()) : said;
  }

  const TempFolder folder_;
  const DescribedCore core_ = described_core_of<Toy>("toy", {});
  const SweptCore swept_ = swept_core(core_);
};

constexpr const char* kAllTypes =
    R"("/start/charge": {"uniform": [-0.3, 0.1]}, "/start/hits": {"grid": [-4, 2, 4]},
    "/start/hot": {"choice": [true, false]}, "/start/mood": {"choice": ["wild", 0]},
    "/start/ticks": {"uniform": [0, 18446744073709551615]}, "/inputs/push": {"member": true})";

// A value of a column as the core has it.
Word word_at(const Column& column, std::size_t row) {
  Word word = 0;
  with_numbers(column, [&](const auto& values) { word = word_of(values[row]); });
  return word;
}

TEST_F(DescribedSweep, KeepsWhatTheRunsOfItsMembersGive) {
  const PlayableSweep sweep = load(kAllTypes);
  std::vector<Table> tables = sweep.contents.tables;
  ASSERT_EQ(tables.size(), 6u);
  const std::int64_t rows = WorkPart{1, 2}.rows(12);
  EXPECT_EQ(sweep.make_player()({1, 2}, 0, rows, tables).steps, rows * 5);
  for (std::int64_t row = 0; row < rows; ++row) {
    const DescribedScenario scenario =
        parse_described_scenario(core_.description, sweep.member_text(1 + 2 * row), "member");
    EXPECT_EQ(scenario.name, "toy-member-" + std::to_string(1 + 2 * row));
    const DescribedSummary run = play(core_, scenario, {});
    const auto at = static_cast<std::size_t>(row);
    for (std::size_t place = 0; place < run.final.size(); ++place)
      EXPECT_EQ(word_at(tables[1].columns[place], at), run.final[place]) << tables[1].columns[place].name;
    EXPECT_EQ(word_at(tables[2].columns[0], at), word_of(run.contacts[0]));
    const auto hash = std::get<Codes>(tables[0].columns[1].values).codes.begin() + row * 16;
    EXPECT_TRUE(std::equal(run.state_hash.begin(), run.state_hash.end(), hash));
    EXPECT_EQ(word_at(tables[3].columns[2], at), scenario.start[1].second) << "the least of hits";
    EXPECT_EQ(word_at(tables[4].columns[2], at), run.final[2]) << "the most of hits";
  }
  EXPECT_EQ(tables[3].columns.size(), 4u) << "neither hot nor mood";
}

TEST_F(DescribedSweep, IsReadBackInTheValuesOwnTypes) {
  const PlayableSweep sweep = load(kAllTypes);
  EnsembleHead head = swept_.head;
  head.sweep_text = sweep.text;
  head.members = 12;
  static_cast<void>(compute_sweep(sweep, head, folder_.at("toy.h5"), 1));
  const EnsembleReader reader(folder_.at("toy.h5"), swept_.read_contents);
  std::vector<Table> played = sweep.contents.tables;
  static_cast<void>(sweep.make_player()({}, 0, 12, played));
  set_inputs(sweep.contents.plan, {}, 0, 12, played.back());
  for (std::size_t table = 0; table < played.size(); ++table)
    for (std::size_t column = 0; column < played[table].columns.size(); ++column) {
      Column rows = reader.tables()[table].columns[column];
      reader.read(table, column, 0, 12, rows);
      for (std::size_t row = 0; row < length(rows) * rows.width; ++row)
        EXPECT_EQ(word_at(rows, row), word_at(played[table].columns[column], row)) << rows.name;
    }
  EXPECT_EQ(played[1].columns[5].value_names, (std::vector<std::string>{"calm", "wild"}));
  EXPECT_EQ(played[1].columns[1].stored_as, ValueType::float32);
  EXPECT_EQ(reader.head().core_name, "toy");
}

TEST_F(DescribedSweep, RefusesWhatAKeyCannotHoldAndTheFirstMemberWhoseKeysDoNotFitAsApproved) {
  std::string text;
  const auto add = [&](const auto&... sweep) { text += refusal(sweep...) + "\n"; };
  for (const char* const vary :
       {R"("/start/hot": {"uniform": [0, 1]})", R"("/start/hits": {"choice": [40000]})",
        R"("/start/charge": {"uniform": [0, 1.5]})", R"("/start/charge": {"uniform": [0, 1.0001]})",
        R"("/start/ticks": {"choice": [-1]})", R"("/start/mood": {"choice": ["mild"]})",
        R"("/inputs/pish": {"choice": [1]})"})
    add(vary);
  add(R"("/inputs/push/-": {"choice": [1]})", R"(, "inputs": {"push": [1, 2, 3, 4]})");
  // Members are looked at one by one only where keys depend on one another.
  const std::string steps = R"("/steps": {"grid": [5, 16, 12]})";
  const std::string hold = R"(, "events": [{"step": 4, "hold": {}}])";
  EXPECT_EQ(refusal(steps) + refusal(steps, hold), "");
  add(R"("/events/0/step": {"grid": [0, 11, 12]})", hold);
  add(steps, R"(, "inputs": {"push": [1, 2, 3, 4, 5]})");
  add(steps, "", R"({"dt_s": [1, 2, 3, 4, 5]})");
  expect_approved("tests/unit/tools/described/refused_sweeps.txt", text);
}

TEST_F(DescribedSweep, AnEarlyEndIsCountedAndTheFirstNamed) {
  const PlayableSweep sweep = load(R"("/start/x_px": {"grid": [0, 99, 12]})");
  std::vector<Table> tables = sweep.contents.tables;
  const RowPlayer player = sweep.make_player();
  SweepTally tally = player({}, 0, 9, tables);
  EXPECT_EQ(tally.early_ends, 0);
  tally += player({}, 9, 3, tables);
  EXPECT_EQ(tally.early_ends, 1);
  EXPECT_EQ(tally.first_early_end, "member 11: row 1: off the table");
  EXPECT_EQ(std::bit_cast<double>(word_at(tables[1].columns[0], 2)), 99.0) << "its last row";
}

}  // namespace
}  // namespace hyrax

// What of a replay is a stored run's, wherever one place of it is changed; and runs that differ are put down
// to the core only where the accepted core gives the golden file.
#include <gtest/gtest.h>

#include "sim/cause/cause_groups.h"
#include "sim/cause/run_match.h"
#include "sim/core/listing_core.h"
#include "tests/unit/sim/replay/kept_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

Core core_with_gravity(double gravity_px_per_s2) {
  Constants constants = shipped_core().constants.value();
  constants.gravity_px_per_s2 = gravity_px_per_s2;
  return listing_core(constants);
}

// A program whose core may be another one than the accepted, which is the shipped one.
struct Program {
  [[nodiscard]] std::string cause_of(const StoredRun& golden, const StoredRun& fresh,
                                     const std::string& scenario_change = "",
                                     bool is_as_blessed = true) const {
    const DifferingRun run{golden, fresh, scenario_change, is_as_blessed, names_accepted_core};
    const Cause cause = group_by_cause({run}, base()).at(0).cause;
    return "  " + std::string(name_of(cause.kind)) + ": " + cause.detail + "\n";
  }
  [[nodiscard]] CauseBase base() const {
    return {.program = core,
            .accepted = has_accepted_core ? &shipped_core() : nullptr,
            .has_further_members = has_further_members,
            .why_not_played = "no accepted core",
            .is_same_core = is_same_core,
            .core_change = "GRAVITY 1200 -> 1250",
            .calls_libm = calls_libm};
  }

  Core core = shipped_core();
  bool is_same_core = false;
  bool has_accepted_core = true;
  bool names_accepted_core = true;
  bool has_further_members = false;
  bool calls_libm = false;
};

// The golden file's program had another clock, or other inputs.
std::string causes_of_other_frame_times() {
  std::string causes = "Other frame times; in the last, in a long run\n";
  for (const std::int64_t steps : {std::int64_t{300}, std::int64_t{12000}}) {
    const Scenario scenario = fling_at(60.0, steps);
    StoredRun golden = kept_run(fling_at(60.0, steps, {{std::int64_t{0}, Hitch{1.0 / 59.0}}}));
    golden.scenario = scenario;
    golden.inputs.clear();
    causes += Program().cause_of(golden, kept_run(scenario));
  }
  return causes + "Other frame times, and another input\n" +
         Program().cause_of(kept_run(fling_at(59.0, 300, {{std::int64_t{7}, Stop{}}})),
                            kept_run(fling_at(60.0, 300)));
}

std::string causes_of_other_inputs() {
  const auto cause_of = [](const std::vector<Event>& blessed, const std::vector<Event>& now,
                           bool has_effect_alone = false) {
    const Scenario scenario = fling_at(60.0, 300, now);
    StoredRun golden = kept_run(fling_at(60.0, 300, blessed));
    golden.scenario = scenario;
    if (has_effect_alone) golden.inputs = inputs_of(scenario, 300);
    return Program().cause_of(golden, kept_run(scenario));
  };
  const Fling fling{{-1500.0, -900.0}}, faster{{-1500.0, -901.0}};
  const Event at_40{std::int64_t{40}, fling}, at_41{std::int64_t{41}, fling},
      faster_at_40{std::int64_t{40}, faster}, hitch{std::int64_t{40}, Hitch{0.2}},
      shorter{std::int64_t{40}, Hitch{0.1}};
  return "A fling in another frame, of another velocity, one more\n" + cause_of({at_41}, {at_40}) +
         cause_of({faster_at_40}, {at_40}) + cause_of({}, {at_40}) +
         "The same fling, whose effect is another\n" + cause_of({faster_at_40}, {at_40}, true) +
         "A hitch of another length, one less, one more\n" + cause_of({hitch}, {shorter}) +
         cause_of({hitch}, {}) + cause_of({}, {hitch});
}

std::string causes_of_another_scenario() {
  Program program;
  const Scenario scenario = fling_at(60.0, 300);
  Scenario faster = scenario;
  faster.start_velocity.vx_px_per_s += 1.0;
  const std::string change = "/start/vx_px_per_s 2400 -> 2401";
  const StoredRun golden = kept_run(scenario);
  std::string causes = "Another start, another length\n" + program.cause_of(golden, kept_run(faster), change);
  for (const std::int64_t steps : {299, 301})
    causes += program.cause_of(golden, kept_run(fling_at(60.0, steps)), "/steps 300 -> other");
  program.core = core_with_gravity(1250.0);  // It changes the run by itself, whatever the core does.
  causes += "Another start, and another core\n" +
            program.cause_of(golden, kept_run(faster, program.core), change) +
            "And neither core gave the golden file, which the accepted one is, and is not, said to have\n";
  for (const bool is_judged : {true, false}) {
    program.names_accepted_core = is_judged;
    causes += program.cause_of(kept_run(scenario, core_with_gravity(1300.0)), kept_run(faster), change);
  }
  return causes;
}

std::string unknown_causes() {
  Program same, unplayed, of_another, of_members, of_libm;
  same.core = core_with_gravity(1250.0);
  same.is_same_core = true;
  unplayed.has_accepted_core = of_another.names_accepted_core = false;
  of_members.has_further_members = of_libm.calls_libm = true;
  const Scenario scenario = fling_at(60.0, 300), lasting = fling_at(60.0, 12'000);  // Kept as blocks.
  const StoredRun shipped = kept_run(scenario), by_1250 = kept_run(scenario, same.core),
                  by_1300 = kept_run(scenario, core_with_gravity(1300.0));
  StoredRun of_contacts = shipped;
  of_contacts.contacts[0].overshoot_px += 1.0;
  return "The core is the accepted one; there is no accepted one; it is not the blessed one\n" +
         same.cause_of(shipped, by_1250) + unplayed.cause_of(shipped, by_1250) +
         of_another.cause_of(shipped, by_1250) +
         "The accepted step gives other bits: of a core with further members, with libm, in a long run\n" +
         of_members.cause_of(by_1300, shipped) + of_libm.cause_of(by_1300, shipped) +
         Program().cause_of(kept_run(lasting, core_with_gravity(1300.0)), kept_run(lasting)) +
         "Other contacts alone\n" + Program().cause_of(of_contacts, shipped);
}

std::string causes_of_changed_golden_files() {
  const Scenario scenario = fling_at(60.0, 300);
  const StoredRun fresh = kept_run(scenario);
  StoredRun golden = fresh, renamed = fresh;
  golden.rows.x_px[200] += 1.0;
  golden.state_hash.front() = golden.state_hash.front() == 'a' ? 'b' : 'a';
  renamed.scenario.start_velocity.vx_px_per_s += 1.0;
  return "A golden file that was changed: a row, then with checksums that agree; its scenario\n" +
         Program().cause_of(golden, fresh, "", false) + Program().cause_of(golden, fresh) +
         Program().cause_of(renamed, fresh, "/start/vx_px_per_s 2401 -> 2400", false);
}

TEST(Cause, OfRunsThatDifferIsTheOneApproved) {
  expect_approved("tests/unit/sim/cause/causes.txt",
                  causes_of_other_frame_times() + causes_of_other_inputs() + causes_of_another_scenario() +
                      unknown_causes() + causes_of_changed_golden_files());
}

TEST(Causes, AreGroupedTheMostRunsFirstAndTheUnknownLast) {
  const Program program;
  const Scenario scenario = fling_at(60.0, 300);
  const StoredRun golden = kept_run(scenario);
  const auto run = [&](const char* scenario_change, bool is_repeated) {
    return DifferingRun{golden, golden, scenario_change, true, true, is_repeated};
  };
  const std::vector<DifferingRun> runs = {run("", false),         run("", false),
                                          run("", false),         run("/a 1 -> 2", true),
                                          run("/b 1 -> 2", true), run("/b 1 -> 2", true)};
  const std::vector<CauseGroup> groups = group_by_cause(runs, program.base());
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].runs, (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(groups[1].runs, std::vector<std::size_t>{3});
  EXPECT_EQ(groups[2].runs, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(groups[2].cause.detail, kNotRepeated);
}

constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);

class StoredRuns : public testing::Test {
 protected:
  [[nodiscard]] RunMatch match_of(const StoredRun& run) const { return match(shipped_core(), scenario, run); }

  Scenario scenario = fling_at(60.0, 300);
};

TEST_F(StoredRuns, MatchInRowsTimesAndContacts) {
  const StoredRun whole = kept_run(scenario);
  EXPECT_TRUE(match_of(whole).is_whole());
  for (const std::size_t row : {0U, 1U, 150U, 299U, 300U}) {
    StoredRun run = whole;
    run.rows.t_s[row] += 1.0;
    EXPECT_FALSE(match_of(run).times) << row;
    EXPECT_TRUE(match_of(run).rows) << row;
    run = whole;
    run.rows.vx_px_per_s[row] += 1.0;
    EXPECT_FALSE(match_of(run).rows) << row;
  }
  void (*const changes[])(StoredRun&, std::size_t) = {
      [](StoredRun& run, std::size_t contact) { ++run.contacts[contact].step; },
      [](StoredRun& run, std::size_t contact) { ++run.contacts[contact].last_step; },
      [](StoredRun& run, std::size_t contact) { run.contacts[contact].wall = Wall::top; },
      [](StoredRun& run, std::size_t contact) { run.contacts[contact].vx_after_px_per_s += 1.0; },
      [](StoredRun& run, std::size_t) { ++run.contacts_total; },
      [](StoredRun& run, std::size_t) { run.contacts.pop_back(); }};
  for (const auto& change : changes)
    for (std::size_t contact = 0; contact < whole.contacts.size(); ++contact) {
      StoredRun run = whole;
      change(run, contact);
      EXPECT_FALSE(match_of(run).contacts) << contact;
      EXPECT_TRUE(match_of(run).rows) << contact;
    }
}

TEST_F(StoredRuns, MatchInBlocksHoweverTheyAreCounted) {
  for (const std::int64_t steps : {kRows - 1, kRows, 5 * kRows - 1, 5 * kRows + 7}) {
    scenario = fling_at(60.0, steps);
    const StoredRun whole = kept_run(scenario);
    EXPECT_TRUE(match_of(whole).is_whole()) << steps;
    for (std::size_t block = 0; block < whole.blocks.size(); ++block) {
      StoredRun run = whole;
      run.blocks[block].keyframe.row.t_s += 1.0;
      EXPECT_FALSE(match_of(run).times) << steps << ", block " << block;
      run = whole;
      run.blocks[block].digest[0] ^= 1;
      EXPECT_FALSE(match_of(run).rows) << steps << ", block " << block;
    }
  }
}

// Those of the block that differs, and of the one before it.
TEST_F(StoredRuns, ShowTheStepsAroundTheFirstDifference) {
  const Scenario even = fling_at(60.0, 4 * kRows + 9);
  for (const std::int64_t frame : {std::int64_t{3}, kRows, 2 * kRows - 2, 2 * kRows - 1, 4 * kRows + 5}) {
    Scenario flung = even;
    flung.events = {{frame, Fling{{-900.0, -900.0}}}};
    const std::vector<ObservedStep> steps = observed_steps(kept_run(flung), kept_run(even), shipped_core());
    const std::int64_t block = (frame + 1) / kRows;  // Of the first row that differs.
    EXPECT_EQ(steps.front().step, std::max<std::int64_t>(0, block - 1) * kRows + 1) << frame;
    EXPECT_GE(steps.back().step, std::min((block + 1) * kRows - 1, 4 * kRows + 9)) << frame;
    EXPECT_EQ(std::ranges::count(steps, true, &ObservedStep::follows_input), 1) << frame;
    flung.events = {{frame, Resize{Size{1900, 1060}, {}}}, {frame, Hitch{0.1}}};  // They set no state.
    EXPECT_EQ(std::ranges::count(observed_steps(kept_run(flung), kept_run(even), shipped_core()), true,
                                 &ObservedStep::follows_input),
              0);
  }
}

}  // namespace
}  // namespace hyrax

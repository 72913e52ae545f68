// What of a replay is a stored run's, wherever one place of it is changed; and runs that differ are put down
// to the core only where the accepted core gives the golden file.
#include <gtest/gtest.h>

#include "sim/cause/cause_groups.h"
#include "sim/cause/run_match.h"
#include "sim/core/listing_core.h"
#include "tests/unit/sim/replay/kept_run.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

Core core_with_gravity(double gravity_px_per_s2) {
  Constants constants = shipped_core().constants.value();
  constants.gravity_px_per_s2 = gravity_px_per_s2;
  return listing_core(constants);
}

// A program whose core may be another one than the accepted, which is the shipped one.
struct Program {
  [[nodiscard]] Cause cause_of(const StoredRun& golden, const StoredRun& fresh,
                               const std::string& scenario_change = "", bool is_as_blessed = true) const {
    return group_by_cause({{golden, fresh, scenario_change, is_as_blessed, names_accepted_core}}, base())
        .at(0)
        .cause;
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

TEST(Cause, IsUnknownWhereTheCoreIsTheAcceptedOneOrThereIsNone) {
  Program program;
  program.is_same_core = true;
  program.core = core_with_gravity(1250.0);
  const Scenario scenario = fling_at(60.0, 300);
  const StoredRun golden = kept_run(scenario), fresh = kept_run(scenario, program.core);
  EXPECT_EQ(program.cause_of(golden, fresh),
            (Cause{CauseKind::unknown,
                   "the core is the accepted one, and its step gives the golden file, but this program does "
                   "not: its compiler, flags or processor, or a fault of the program"}));
  program.is_same_core = false;
  program.has_accepted_core = false;
  EXPECT_EQ(program.cause_of(golden, fresh), (Cause{CauseKind::unknown, "no accepted core"}));
  program.has_accepted_core = true;
  program.names_accepted_core = false;
  EXPECT_EQ(program.cause_of(golden, fresh).detail, "blessed with another core than the accepted one");
}

// The golden file's program had another clock, or other inputs.
TEST(Cause, IsTheClockWhereFrameTimesDiffer) {
  const Program program;
  for (const std::int64_t steps : {std::int64_t{300}, std::int64_t{12000}}) {
    const Scenario scenario = fling_at(60.0, steps);
    Scenario slow = scenario;
    slow.events = {{std::int64_t{0}, Hitch{1.0 / 59.0}}};
    StoredRun golden = kept_run(slow);
    golden.scenario = scenario;
    golden.inputs.clear();
    const std::string detail =
        steps == 300
            ? "the clock gives other frame times: dt of row 1 0.01694915254237288 -> 0.016666666666666666 s"
            : "the clock counts time differently: t of row 4096 68.26694915254237 -> 68.26666666666667 s";
    EXPECT_EQ(program.cause_of(golden, kept_run(scenario)), (Cause{CauseKind::clock, detail}));
    if (steps != 300) continue;
    golden = kept_run(fling_at(59.0, 300, {{std::int64_t{7}, Stop{}}}));
    EXPECT_EQ(program.cause_of(golden, kept_run(scenario)),
              (Cause{CauseKind::clock, detail + "; inputs differ: stop in frame 7 -> none"}));
  }
}

TEST(Cause, IsAnInputThatDiffers) {
  const Program program;
  const auto cause_of = [&program](const Event& blessed, const Event& now, bool has_effect_alone) {
    const Scenario scenario = fling_at(60.0, 300, {now});
    StoredRun golden = kept_run(fling_at(60.0, 300, {blessed}));
    golden.scenario = scenario;
    if (has_effect_alone) golden.inputs = inputs_of(scenario, 300);
    return program.cause_of(golden, kept_run(scenario));
  };
  const Event fling{std::int64_t{40}, Fling{{-1500.0, -900.0}}};
  EXPECT_EQ(cause_of({std::int64_t{41}, fling.action}, fling, false),
            (Cause{CauseKind::input, "inputs differ: fling in frame 41 -> fling in frame 40"}));
  EXPECT_EQ(cause_of({std::int64_t{40}, Fling{{-1500.0, -901.0}}}, fling, false),
            (Cause{CauseKind::input, "inputs differ: fling in frame 40: other values"}));
  EXPECT_EQ(cause_of({std::int64_t{40}, Fling{{-1500.0, -901.0}}}, fling, true),
            (Cause{CauseKind::input, "an input has another effect"}));
  const StoredRun golden = kept_run(fling_at(60.0, 300)), fresh = kept_run(fling_at(60.0, 300, {fling}));
  EXPECT_EQ(program.cause_of(golden, fresh).detail, "inputs differ: none -> fling in frame 40");
  // The frame of a hitch has another length, whatever the clock gives.
  EXPECT_EQ(cause_of({std::int64_t{40}, Hitch{0.2}}, {std::int64_t{40}, Hitch{0.1}}, false).kind,
            CauseKind::input);
  const StoredRun hitched = kept_run(fling_at(60.0, 300, {{std::int64_t{40}, Hitch{0.1}}}));
  EXPECT_EQ(program.cause_of(hitched, golden),
            (Cause{CauseKind::input, "inputs differ: hitch in frame 40 -> none"}));
  EXPECT_EQ(program.cause_of(golden, hitched),
            (Cause{CauseKind::input, "inputs differ: none -> hitch in frame 40"}));
}

TEST(Cause, IsTheScenariosOwnText) {
  Program program;
  const Scenario scenario = fling_at(60.0, 300);
  Scenario faster = scenario;
  faster.start_velocity.vx_px_per_s += 1.0;
  const StoredRun golden = kept_run(scenario);
  EXPECT_EQ(program.cause_of(golden, kept_run(faster), "/start/vx_px_per_s 2400 -> 2401"),
            (Cause{CauseKind::scenario, "/start/vx_px_per_s 2400 -> 2401"}));
  for (const std::int64_t steps : {299, 301}) {
    Scenario other = scenario;
    other.length = steps;
    EXPECT_EQ(program.cause_of(golden, kept_run(other), "/steps 300 -> other").kind, CauseKind::scenario);
  }
  program.core = core_with_gravity(1250.0);  // It changes the run by itself, whatever the core does.
  EXPECT_EQ(program.cause_of(golden, kept_run(faster, program.core), "/start/vx_px_per_s 2400 -> 2401").kind,
            CauseKind::scenario);
  const StoredRun by_another = kept_run(scenario, core_with_gravity(1300.0));
  for (const bool is_judged : {true, false}) {
    program.names_accepted_core = is_judged;
    EXPECT_EQ(
        program.cause_of(by_another, kept_run(faster), "/a 1 -> 2"),
        (Cause{CauseKind::unknown, "the scenario changed since it was blessed: /a 1 -> 2; " +
                                       std::string(is_judged ? "the accepted core" : "this program's core") +
                                       " does not give the golden file either"}));
  }
}

TEST(Cause, IsUnknownWhereTheAcceptedStepGivesOtherBits) {
  const Scenario scenario = fling_at(60.0, 300);
  const StoredRun fresh = kept_run(scenario), golden = kept_run(scenario, core_with_gravity(1300.0));
  Program of_members, of_libm;
  of_members.has_further_members = of_libm.calls_libm = true;
  const Cause other_bits{CauseKind::unknown,
                         "the accepted core gives other bits, too: the compiler, its flags, the processor, "
                         "the C library, or a fault of the program"};
  for (const Program& program : {of_members, of_libm}) EXPECT_EQ(program.cause_of(golden, fresh), other_bits);
  const Scenario lasting = fling_at(60.0, 12'000);  // Kept as blocks.
  EXPECT_EQ(Program().cause_of(kept_run(lasting, core_with_gravity(1300.0)), kept_run(lasting)), other_bits);
  StoredRun of_contacts = fresh;
  of_contacts.contacts[0].overshoot_px += 1.0;
  EXPECT_EQ(Program().cause_of(of_contacts, fresh),
            (Cause{CauseKind::unknown, "all rows agree, but what is measured of the contacts differs"}));
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

TEST(Cause, IsAGoldenFileThatWasChanged) {
  Program program;
  const Scenario scenario = fling_at(60.0, 300);
  StoredRun golden = kept_run(scenario);
  golden.rows.x_px[200] += 1.0;
  golden.state_hash.front() = golden.state_hash.front() == 'a' ? 'b' : 'a';
  const StoredRun fresh = kept_run(scenario);
  const Cause changed{CauseKind::golden, "the golden file was changed since it was blessed"};
  EXPECT_EQ(program.cause_of(golden, fresh, "", false), changed);
  EXPECT_EQ(program.cause_of(golden, fresh),  // Its checksums were made to agree.
            (Cause{CauseKind::golden, "the golden file's scenario and inputs do not give its rows"}));
  StoredRun renamed = kept_run(scenario);
  renamed.scenario.start_velocity.vx_px_per_s += 1.0;
  EXPECT_EQ(program.cause_of(renamed, fresh, "/start/vx_px_per_s 2401 -> 2400", false), changed);
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

// What scenarios need: parts that are known to matter, and not to, and what the replay, which knows nothing
// of parts, touches.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <stdexcept>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/needs/needs.h"
#include "sim/study/study.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/sim/study/clocks.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

Scenario scenario_named(const std::string& name) {
  return load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/" + name + ".json");
}

// With a fake clock on which every part costs the same: no time is saved.
ScenarioNeeds needs_of(const Scenario& scenario) {
  NeedsOptions options;
  options.cost.rounds = 1;
  return study_needs(shipped_core(), scenario, options, metered<steady_ns>);
}

PartNeed part_of(const ScenarioNeeds& needs, const std::string& part) {
  for (const PartNeed& need : needs.parts)
    if (need.part == part) return need;
  ADD_FAILURE() << "no part " << part;
  return {};
}

TEST(Needs, IncludeEventsAndJitter) {
  const ScenarioNeeds needs = needs_of(scenario_named("flings/corner-fling"));
  EXPECT_EQ(part_of(needs, "jitter").need, Need::needed);
  EXPECT_EQ(part_of(needs, "fling, frame 120").need, Need::needed);
  EXPECT_EQ(part_of(needs, "hold, frame 300").need, Need::needed);
  // It stops a sprite that has almost settled.
  EXPECT_EQ(part_of(needs, "stop, frame 517").need, Need::below);
}

TEST(Needs, DoNotIncludeAPartThatMovesThePathByTheToleranceItself) {
  EXPECT_EQ(need_of({.is_same_bits = false, .path_px = 1.0}, 1.0), Need::below);
  EXPECT_EQ(need_of({.is_same_bits = false, .path_px = std::nextafter(1.0, 2.0)}, 1.0), Need::needed);
}

TEST(Needs, TheDistanceAtTheEndIsZeroWherePathsMeetAgain) {
  Scenario scenario = scenario_named("flings/first-fling");
  scenario.events = {{std::int64_t{40}, Fling{{900.0, 0.0}}},
                     {std::int64_t{80}, Stop{}},
                     {std::int64_t{80}, Place{{500.0, 300.0}}}};
  const PathDifference difference = part_of(needs_of(scenario), "fling, frame 40").difference;
  EXPECT_GT(difference.path_px, 100.0);
  EXPECT_EQ(difference.end_px, 0.0);
}

// At 1000 px/s the rows of one step number are up to 30 px apart, at equal times what drag does in more or
// fewer frames.
TEST(Needs, JitterIsJudgedAtEqualTimes) {
  Scenario scenario = scenario_named("flings/first-fling");
  scenario.window = {100'000, 100'000};
  scenario.start_velocity = {1000.0, 0.0};
  scenario.length = std::int64_t{60};
  for (const Jitter jitter :
       {Jitter{Jitter::Kind::uniform, 0.2, 3}, Jitter{Jitter::Kind::missed_frames, 0.1, 3}}) {
    scenario.clock.jitter = jitter;
    const PartNeed part = part_of(needs_of(scenario), "jitter");
    EXPECT_GT(part.difference.path_px, 0.05);
    EXPECT_LT(part.difference.path_px, 6.0);
    EXPECT_LT(part.difference.end_px, 6.0);
  }
}

TEST(Needs, JitterLeavesEventsAndContactsAtTheirTimes) {
  Scenario scenario = scenario_named("flings/first-fling");
  scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.1, 3};
  EXPECT_LT(part_of(needs_of(scenario), "jitter").difference.path_px, 40.0);
  scenario.length = std::int64_t{120};
  scenario.events = {{std::int64_t{60}, Place{{1500.0, 300.0}}}};
  const PartNeed part = part_of(needs_of(scenario), "jitter");
  EXPECT_LT(part.difference.path_px, 60.0) << "the place is 1000 px away, the wall's bounce a frame late";
  EXPECT_LE(part.difference.contacts_moved, 1);
}

// Each run takes 100 us; of a long one, 10,000 frames are run.
TEST(Needs, TheTimeOfAStepIsThatOfTheFramesTimed) {
  Scenario scenario = scenario_named("flings/first-fling");
  for (const auto& [steps, step_ns] : {std::pair{std::int64_t{1'000}, 100.0}, {10'500, 10.0}}) {
    scenario.length = steps;
    EXPECT_EQ(needs_of(scenario).step_ns.median, step_ns) << steps;
  }
}

TEST(Script, OfALongScenarioIsItsFirstFramesWithTheirInputs) {
  Scenario scenario = scenario_named("flings/first-fling");
  for (const std::int64_t more : {0, 1}) {
    scenario.events = {{kScriptFramesMax - 1, Stop{}}};
    if (more > 0) scenario.events.push_back({kScriptFramesMax, Stop{}});
    scenario.length = kScriptFramesMax + more;
    const Script script = script_of(scenario);
    EXPECT_EQ(script.is_cut, more == 1);
    EXPECT_EQ(std::ssize(script.frames_s), kScriptFramesMax);
    EXPECT_EQ(script.inputs, std::vector<std::string>{"stop, frame 99999"});
  }
}

Result studied(const std::vector<std::string>& names, std::shared_ptr<const StepProgram> core_step = nullptr,
               std::optional<double> within_px = {}, const CostMeter& measure_costs = metered<steady_ns>,
               bool is_short = true) {
  StudyRequest request{.core = shipped_core(),
                       .is_quick = true,
                       .within_px = within_px,
                       .core_step = std::move(core_step),
                       .machine = "some machine",
                       .measure_costs = measure_costs};
  for (const std::string& name : names) {
    request.scenarios.push_back({name, scenario_named(name)});
    Scenario& scenario = request.scenarios.back().scenario;
    if (is_short) scenario.length = std::int64_t{60};
    scenario.name += std::to_string(request.scenarios.size());
  }
  for (const Study& study : studies())
    if (study.name == "needs") return study.run(request);
  throw std::logic_error("no study needs");
}

TEST(NeedsStudy, OfSeveralInputsOfAKindTheMostNeededCounts) {
  ScenarioNeeds needs;
  for (const Need need : {Need::below, Need::needed, Need::not_exercised, Need::below})
    needs.parts.push_back({.part = "fling, step 1", .model_part = {}, .need = need});
  const auto fling = std::ranges::find(coverage_columns(), "fling") - coverage_columns().begin();
  EXPECT_EQ(coverage_of(needs)[static_cast<std::size_t>(fling)], Need::needed);
}

TEST(NeedsStudy, ManyScenesHaveACoverageTableAndOneFigure) {
  const Result result = studied(std::vector<std::string>(5, "flings/first-fling"));
  EXPECT_EQ(row_count(result.tables[2]), 0u);
  ASSERT_EQ(result.figures.size(), 1u);
  expect_approved("tests/unit/sim/study/approved/needs-of-many.txt",
                  described(result.verdict) + described(result.tables[1]) + described(result.figures[0]));
  EXPECT_EQ(studied(std::vector<std::string>(4, "flings/first-fling")).figures.size(), 4u);
}

TEST(NeedsStudy, CountsThePathsOfTheStepThatManyScenariosTake) {
  const auto last_of = [](const Result& result) { return std::get<std::string>(result.verdict.text.back()); };
  const std::shared_ptr<const StepProgram> step =
      make_step_program(read_step(shipped_core().record.step).value());
  EXPECT_EQ(last_of(studied({"flings/first-fling", "hard/sprite-larger-than-window", "flings/first-fling",
                             "flings/first-fling", "flings/first-fling"},
                            step)),
            "They take 4 of 12 paths of the step.");
  EXPECT_EQ(last_of(studied({"flings/first-fling"})).find("paths"), std::string::npos) << "not recorded";
}

TEST(NeedsStudy, PrintsASavingOnlyAboveItsNoise) {
  PartNeed none, noise, saving;
  none.saved_ns_per_step = median_of({-1.0, 0.0, 1.0});
  noise.saved_ns_per_step = median_of({-0.1, 1.0, 2.0});
  saving.saved_ns_per_step = median_of({0.1, 1.0, 2.0});
  EXPECT_FALSE(none.saves());
  EXPECT_FALSE(noise.saves());
  EXPECT_TRUE(saving.saves());
  EXPECT_FALSE(PartNeed().saves()) << "not measured";
}

// How far a clock drifts depends on when it is asked.
std::string without_measured_drift(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(drift [\d.]+ %)"), "drift N %");
}

TEST(NeedsStudy, SaysWhatIsApproved) {
  const std::vector<std::string> fling = {"flings/first-fling"};
  std::string text =
      "A path that moves by the tolerance is within it\n" + described(studied(fling, nullptr, 0.0).verdict) +
      "A clock that is not steady\n" +
      without_measured_drift(described(studied(fling, nullptr, {}, metered<unsteady_ns>).verdict));
  for (const double within_px : {25.0, 1.0})
    text += "The whole fling within " + six_digits(within_px) + " px\n" +
            described(studied(fling, nullptr, within_px, metered<steady_ns>, false).verdict);
  ScenarioNeeds of_all, of_three;
  for (const std::string& part : coverage_columns())
    of_all.parts.push_back({.part = part, .model_part = {}, .need = Need::needed_jointly});
  of_three.parts = {{"gravity", ModelPart::gravity, {false, 941.0, 105.0, 1, 11}, Need::needed},
                    {"ground", ModelPart::ground, {false, HUGE_VAL, HUGE_VAL, 1, 0}, Need::needed},
                    {"drag", ModelPart::drag, {false, 2.0, 1.0, 1, 1}, Need::needed_jointly}};
  text += "Every part has a scenario\n" + described(coverage_verdict({of_all}, 1.0)) +
          "A bar without bound, and no mark of a tolerance that is zero\n" +
          described(needs_figure(of_three, 0.0));
  expect_approved("tests/unit/sim/study/approved/needs-in-words.txt", text);
}

// The walls that the replay touches. Its rows must be those of the study's script.
std::uint8_t walls_replayed(const Scenario& scenario) {
  TraceSink replayed({.rows_every = 1});
  replay(shipped_core(), scenario, replayed);
  std::uint8_t walls = 0;
  std::size_t step = 0;
  play(script_of(scenario), *shipped_core().constants, AllParts(), [&](const ScriptFrame& frame) {
    const Row& row = replayed.rows().at(++step);
    EXPECT_TRUE(same_bits(frame.to, state_of(row))) << "row " << step;
    // What clamps without moving the sprite by a bit is no contact to the replay.
    EXPECT_EQ(frame.contact & 15 & row.contact, row.contact & 15) << "row " << step;
    walls = static_cast<std::uint8_t>(walls | row.contact);
  });
  return walls;
}

// Exercised only where one of these walls is touched; a wall wherever it is.
constexpr struct {
  ModelPart part;
  int walls;
} kTouching[] = {{ModelPart::left_wall, 1},   {ModelPart::right_wall, 2}, {ModelPart::top_wall, 4},
                 {ModelPart::ground, 8},      {ModelPart::friction, 8},   {ModelPart::rest_rule, 8},
                 {ModelPart::restitution, 15}};

TEST(NeedsOfTheLibrary, AgreeWithTheWallsThatTheReplayTouches) {
  std::vector<ScenarioNeeds> played;
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    if (step_count(scenario) > 5'000) continue;  // The script that parts are left out of is cut.
    SCOPED_TRACE(scenario.name);
    const std::uint8_t walls = walls_replayed(scenario);
    played.push_back(needs_of(scenario));
    for (const PartNeed& need : played.back().parts)
      for (const auto& [part, touching] : kTouching) {
        if (need.model_part != part) continue;
        const bool is_exercised = need.need != Need::not_exercised, is_touched = (walls & touching) != 0;
        EXPECT_LE(is_exercised, is_touched) << need.part;
        if (part < ModelPart::friction) {
          EXPECT_EQ(is_exercised, is_touched) << need.part;
        }
      }
  }
  EXPECT_GT(played.size(), 60u);
  EXPECT_EQ(never_exercised(played), std::vector<std::string>{});
}

}  // namespace
}  // namespace hyrax

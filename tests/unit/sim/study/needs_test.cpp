// What scenes need: parts that are known to matter, and not to.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/replay/replay.h"
#include "sim/study/core.h"
#include "sim/study/needs.h"
#include "sim/study/needs_tables.h"
#include "sim/trajectory/row.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

Scenario scenario_named(const std::string& name) {
  return load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/" + name + ".json");
}

// Time stands still: no time is saved.
SceneNeeds needs_of(const Scenario& scenario, double within_px = 1.0) {
  NeedsOptions options;
  options.within_px = within_px;
  options.cost.repetitions = 1;
  return study_needs(scenario, options, [now_ns = std::int64_t{0}]() mutable { return now_ns += 100'000; });
}

Need need_of_part(const SceneNeeds& scene, const std::string& part) {
  for (const PartNeed& need : scene.parts)
    if (need.part == part) return need.need;
  ADD_FAILURE() << "no part " << part;
  return Need::needed;
}

// The script with every part is the replay's run, so what is left out of it is left out of that.
TEST(Script, WithAllPartsIsTheReplayBitForBit) {
  for (const char* name :
       {"flings/first-fling", "flings/corner-fling", "flings/grab-and-throw", "clocks/jitter-normal",
        "clocks/trace-60-hz", "clocks/hitch-at-contact", "hard/window-of-no-size",
        "hard/sprite-larger-than-window", "flings/kept-aloft", "paper/exact-bounds"}) {
    const Scenario scenario = scenario_named(name);
    Scenario every = scenario;
    every.record_every = 1;
    TraceSink trace({.rows_every = 1});
    replay(every, trace);
    std::size_t row = 1;
    play(script_of(scenario), core_constants(), {}, AllParts(), [&](const State& m, std::uint8_t contact) {
      const Row& wanted = trace.rows().at(row++);
      ASSERT_TRUE(same_bits(m.x_px, wanted.x_px) && same_bits(m.y_px, wanted.y_px) &&
                  same_bits(m.vx_px_per_s, wanted.vx_px_per_s) &&
                  same_bits(m.vy_px_per_s, wanted.vy_px_per_s))
          << name << ", row " << row - 1;
      // What clamps without moving the sprite by a bit is no contact to the replay.
      ASSERT_EQ(contact & 15 & wanted.contact, wanted.contact & 15) << name << ", row " << row - 1;
    });
    EXPECT_EQ(row, trace.rows().size());
  }
}

TEST(Needs, OfAFlingAreWhatItMeets) {
  const SceneNeeds scene = needs_of(scenario_named("flings/first-fling"));
  for (const char* part : {"gravity", "drag", "right wall", "ground", "friction", "restitution"})
    EXPECT_EQ(need_of_part(scene, part), Need::needed) << part;
  for (const char* part : {"left wall", "top"})
    EXPECT_EQ(need_of_part(scene, part), Need::not_exercised) << part;
  EXPECT_TRUE(scene.broken.empty());
  EXPECT_TRUE(scene.comes_to_rest);
}

TEST(Needs, KnowEventsAndJitter) {
  const SceneNeeds scene = needs_of(scenario_named("flings/corner-fling"));
  EXPECT_EQ(need_of_part(scene, "jitter"), Need::needed);
  EXPECT_EQ(need_of_part(scene, "fling, frame 120"), Need::needed);
  EXPECT_EQ(need_of_part(scene, "hold, frame 300"), Need::needed);
  // It stops a sprite that all but lies.
  EXPECT_EQ(need_of_part(scene, "stop, frame 517"), Need::below);
}

TEST(Needs, GrowAsTheToleranceShrinks) {
  const Scenario scenario = scenario_named("flings/corner-fling");
  const auto needed = [&](double within_px) {
    const SceneNeeds scene = needs_of(scenario, within_px);
    return std::count_if(scene.parts.begin(), scene.parts.end(),
                         [](const PartNeed& part) { return part.need == Need::needed; });
  };
  EXPECT_LT(needed(1e6), needed(1.0));
  EXPECT_LT(needed(1.0), needed(0.0));
}

// Alone nobody misses the fling or the restitution of this scene, together one does.
TEST(Needs, SeePartsThatStandInForOneAnother) {
  const SceneNeeds scene = needs_of(scenario_named("paper/rest-threshold"));
  const auto is_joint = [](const PartNeed& part) { return part.need == Need::needed_jointly; };
  EXPECT_GT(std::count_if(scene.parts.begin(), scene.parts.end(), is_joint), 0);
  EXPECT_TRUE(scene.broken.empty());
  EXPECT_LE(scene.without_all_unneeded.path_px, 1.0);
}

TEST(Needs, TheControlFailsWhereSomethingNeededIsLeftOut) {
  const Script script = script_of(scenario_named("flings/first-fling"));
  Parts parts;
  parts.leave_out(Part::left_wall);
  EXPECT_TRUE(difference_without(script, {}, parts).is_same_bits);
  parts.leave_out(Part::drag);
  EXPECT_EQ(need_of(difference_without(script, {}, parts), 1.0), Need::needed);
}

// What the replay meets of the first fling is the right wall and the ground.
TEST(Needs, AreHeldToTheWallsThatTheReplayMeets) {
  const Scenario scenario = scenario_named("flings/first-fling");
  const auto contradictions = [&](Part part, Need need) {
    PartNeed changed;
    changed.part = kPartNames[static_cast<std::size_t>(part)];
    changed.model_part = part;
    changed.need = need;
    return contradictions_of(scenario, {changed}).size();
  };
  for (const Part part : {Part::right_wall, Part::ground}) {
    EXPECT_EQ(contradictions(part, Need::below), 0u);
    EXPECT_EQ(contradictions(part, Need::not_exercised), 1u);
  }
  for (const Part part : {Part::left_wall, Part::top_wall}) {
    EXPECT_EQ(contradictions(part, Need::not_exercised), 0u);
    EXPECT_EQ(contradictions(part, Need::below), 1u);
  }
  EXPECT_EQ(contradictions(Part::friction, Need::not_exercised), 0u);
}

TEST(Needs, CountContactsThatMove) {
  const Script script = script_of(scenario_named("flings/first-fling"));
  Parts parts;
  parts.leave_out(Part::right_wall);
  const PathDifference difference = difference_without(script, {}, parts);
  EXPECT_GE(difference.contacts_moved, 1);
  EXPECT_GT(difference.first_step, 1);
  EXPECT_GT(difference.end_px, 100.0);
}

TEST(Coverage, TellsTheMostThatASceneNeeds) {
  const SceneNeeds scene = needs_of(scenario_named("flings/corner-fling"));
  const std::vector<Need> coverage = coverage_of(scene);
  ASSERT_EQ(coverage.size(), coverage_columns().size());
  const auto at = [&](const char* name) {
    return coverage[static_cast<std::size_t>(
        std::find(coverage_columns().begin(), coverage_columns().end(), name) - coverage_columns().begin())];
  };
  EXPECT_EQ(at("gravity"), Need::needed);
  EXPECT_EQ(at("hitch"), Need::needed);
  EXPECT_EQ(at("stop"), Need::below);
}

TEST(NeedsTables, HaveARowAPartAndAScene) {
  const std::vector<SceneNeeds> scenes = {needs_of(scenario_named("flings/first-fling"))};
  const std::vector<StudyTable> tables = tables_of(scenes, 1.0);
  EXPECT_EQ(row_count(tables[0]), scenes[0].parts.size());
  EXPECT_EQ(row_count(tables[1]), 1u);
  EXPECT_EQ(row_count(tables[2]), 1u);
  EXPECT_EQ(row_count(tables[3]), 0u);
}

}  // namespace
}  // namespace hyrax

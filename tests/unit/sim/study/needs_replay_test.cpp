// What the study of needs says of parts, against the replay, which knows nothing of parts.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/needs/needs.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/study/clocks.h"

namespace hyrax {
namespace {

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

// A wall is exercised if and only if the replay has a contact with it; friction and the rest rule only with a
// ground contact, restitution only with a contact.
bool agrees(const PartNeed& part, std::uint8_t walls) {
  if (!part.model_part) return true;
  const bool is_exercised = part.need != Need::not_exercised;
  switch (*part.model_part) {
    case Part::left_wall:
      return is_exercised == touches(walls, Wall::left);
    case Part::right_wall:
      return is_exercised == touches(walls, Wall::right);
    case Part::top_wall:
      return is_exercised == touches(walls, Wall::top);
    case Part::ground:
      return is_exercised == touches(walls, Wall::ground);
    case Part::friction:
    case Part::rest_rule:
      return !is_exercised || touches(walls, Wall::ground);
    case Part::restitution:
      return !is_exercised || (walls & 15) != 0;
    case Part::gravity:
    case Part::drag:
      return true;
  }
  return false;
}

TEST(NeedsOfTheLibrary, AgreeWithTheWallsThatTheReplayTouches) {
  int played = 0;
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    if (step_count(scenario) > 5'000) continue;  // The script that parts are left out of is cut.
    SCOPED_TRACE(scenario.name);
    ++played;
    const std::uint8_t walls = walls_replayed(scenario);
    NeedsOptions options;
    options.cost.repetitions = 1;
    const ScenarioNeeds needs = study_needs(shipped_core(), scenario, options, steady_ns);
    for (const PartNeed& part : needs.parts)
      EXPECT_TRUE(agrees(part, walls)) << part.part << ", " << name_of(part.need);
  }
  EXPECT_GT(played, 60);
}

TEST(NeedsOfTheLibrary, WouldNotAgreeIfAWallWereMistaken) {
  const std::uint8_t first_fling =
      walls_replayed(load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/flings/first-fling.json"));
  const auto with = [&](Part part, Need need) {
    return agrees({.part = "", .model_part = part, .difference = {}, .need = need}, first_fling);
  };
  for (const Part part : {Part::right_wall, Part::ground}) {
    EXPECT_TRUE(with(part, Need::below));
    EXPECT_FALSE(with(part, Need::not_exercised));
  }
  for (const Part part : {Part::left_wall, Part::top_wall}) {
    EXPECT_TRUE(with(part, Need::not_exercised));
    EXPECT_FALSE(with(part, Need::below));
  }
}

}  // namespace
}  // namespace hyrax

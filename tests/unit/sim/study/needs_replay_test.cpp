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

// Exercised only where one of these walls is touched; a wall wherever it is.
constexpr struct {
  Part part;
  int walls;
} kTouching[] = {{Part::left_wall, 1}, {Part::right_wall, 2}, {Part::top_wall, 4},    {Part::ground, 8},
                 {Part::friction, 8},  {Part::rest_rule, 8},  {Part::restitution, 15}};

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
    for (const PartNeed& need : needs.parts)
      for (const auto& [part, touching] : kTouching) {
        if (need.model_part != part) continue;
        const bool is_exercised = need.need != Need::not_exercised, is_touched = (walls & touching) != 0;
        EXPECT_LE(is_exercised, is_touched) << need.part;
        if (part < Part::friction) {
          EXPECT_EQ(is_exercised, is_touched) << need.part;
        }
      }
  }
  EXPECT_GT(played, 60);
}

}  // namespace
}  // namespace hyrax

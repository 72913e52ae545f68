#include "tools/app/core/controlled_core.h"

#include <gtest/gtest.h>

#include <cfenv>

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

// Rounds downwards from the first step on that begins below 700 px.
class Rounding : public physics {
 public:
  using physics::physics;
  void update(double dt, int window_width, int window_height, int sprite_width, int sprite_height) {
    if (y() > 700.0) std::fesetround(FE_DOWNWARD);
    physics::update(dt, window_width, window_height, sprite_width, sprite_height);
  }
};

TEST(ControlledCore, NamesTheStepThatChangesRoundingAndRestoresIt) {
  for (const bool is_jittered : {false, true}) {
    Scenario scenario = scenario_from({300, 100, 400, 0}, {1920, 1080}, {128, 128}, 60, 600);
    if (is_jittered) scenario.clock.jitter = {Jitter::Kind::missed_frames, 0.1, 3};
    const Core plain = core_of<physics>("plain", {});
    Replay run(plain, scenario);
    while (run.keyframe().row.y_px <= 700.0) run.play_to(run.keyframe().row.step + 1);
    const std::string row = "in the step that makes row " + std::to_string(run.keyframe().row.step + 1) + ";";
    try {
      replay(controlled(core_of<Rounding>("rounding", {})), scenario, std::vector<RowSink*>{});
      FAIL() << "no failure";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.exit_code(), ExitCode::not_strict_ieee);
      EXPECT_NE(std::string(failure.what()).find(row), std::string::npos) << failure.what() << " " << row;
    }
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    replay(controlled(plain), scenario, std::vector<RowSink*>{});
  }
}

}  // namespace
}  // namespace hyrax

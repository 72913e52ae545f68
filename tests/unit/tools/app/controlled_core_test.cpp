#include "tools/app/core/controlled_core.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <stdexcept>
#include <string>

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

// Has a fault from the first step on that begins below 700 px.
template <auto kFault>
class Faulty : public physics {
 public:
  using physics::physics;
  void update(double dt, int window_width, int window_height, int sprite_width, int sprite_height) {
    if (y() > 700.0) kFault();
    physics::update(dt, window_width, window_height, sprite_width, sprite_height);
  }
};
using Rounding = Faulty<[] { std::fesetround(FE_DOWNWARD); }>;
using Throwing = Faulty<[] { throw std::range_error("too deep"); }>;
using ThrowingANumber = Faulty<[] { throw 42; }>;

// Of a run that falls below 700 px.
template <class Class>
void expect_failure(ExitCode exit_code, const std::string& before_row, const std::string& after_row) {
  for (const bool is_jittered : {false, true}) {
    Scenario scenario = scenario_from({300, 100, 400, 0}, {1920, 1080}, {128, 128}, 60, 600);
    if (is_jittered) scenario.clock.jitter = {Jitter::Kind::missed_frames, 0.1, 3};
    const Core plain = core_of<physics>("plain", {});
    Replay run(plain, scenario);
    while (run.keyframe().row.y_px <= 700.0) run.play_to(run.keyframe().row.step + 1);
    const std::string row =
        " in the step that makes row " + std::to_string(run.keyframe().row.step + 1) + after_row;
    try {
      replay(controlled(core_of<Class>("faulty", {})), scenario, std::vector<RowSink*>{});
      FAIL() << "no failure";
    } catch (const CoreFailure& failure) {
      EXPECT_EQ(failure.exit_code(), exit_code);
      EXPECT_EQ(failure.what(), before_row + row);
      EXPECT_EQ(failure.without_row(), before_row + after_row);
    }
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    replay(controlled(plain), scenario, std::vector<RowSink*>{});
  }
}

TEST(ControlledCore, NamesTheStepThatChangesRoundingAndRestoresIt) {
  expect_failure<Rounding>(ExitCode::not_strict_ieee,
                           "the core changes how the processor calculates (rounding or flush-to-zero)",
                           "; remove what sets it from the core");
}

TEST(ControlledCore, NamesTheStepThatThrows) {
  expect_failure<Throwing>(ExitCode::disagreed, "the core throws", ": too deep");
  expect_failure<ThrowingANumber>(ExitCode::disagreed, "the core throws",
                                  ": an exception that is no std::exception");
}

}  // namespace
}  // namespace hyrax

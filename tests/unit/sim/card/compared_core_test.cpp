#include "sim/card/compared_core.h"

#include <cfenv>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

using Step = void (*)(double dt_s);

volatile std::int64_t* updates = nullptr;  // Counted as a core's library does.

void do_nothing(double) {}
void throw_in_a_long_frame(double dt_s) {
  *updates = *updates + 1;
  if (dt_s == 0.25) throw std::runtime_error("");
}
void round_upward(double) { std::fesetround(FE_UPWARD); }
void round_inexactly(double) { std::feraiseexcept(FE_INEXACT | FE_UNDERFLOW); }

// Whose step does something else, and which names no constants.
template <Step kStep>
struct Doing : private physics {
  using physics::physics, physics::x, physics::y, physics::vx, physics::vy, physics::setPos,
      physics::setVelocity, physics::resetVelocity;
  void update(double dt_s, int, int, int, int) { kStep(dt_s); }
};

template <Step kStep>
std::string refusal(const auto& play) {
  PlayWatch watch{};
  updates = &watch.updates;
  const LibraryCore library{.counted = core_of<Doing<kStep>>(kPhysicsModel, {}),
                            .timed = {},
                            .lacking = "GRAVITY",
                            .defect = nullptr};
  EXPECT_FALSE(library.counted.constants);
  const ComparedCore compared = compared_core(1, library, {.why_incomplete = "not traced"}, watch);
  EXPECT_EQ(compared.core.constants->gravity_px_per_s2, 1200.0);
  try {
    play(compared.at("a fling"));
  } catch (const CoreRefused& refusal) {
    EXPECT_EQ(refusal.core, 1);
    EXPECT_EQ(watch.core, 1);
    return refusal.what();
  }
  return "";
}

const auto play_steps = [](const Core& core) { static_cast<void>(core.steps({}, 0.25, {}, 100)); };

TEST(ComparedCore, IsRefusedIfItThrowsWhereverItIsCalled) {
  const auto play_parts = [](const Core& core) {
    std::vector frames_s(50, 0.125);
    frames_s[21] = 0.5;
    static_cast<void>(core.played({}, frames_s, {}, 2));
  };
  const auto play_scenario = [](const Core& core) {
    static_cast<void>(
        replay(core, fling_at(60.0, 100, {{std::int64_t{40}, Stop{}}, {std::int64_t{42}, Hitch{0.25}}})));
  };
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_steps), "throws an exception in a fling, step 1");
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_parts), "throws an exception in a fling, step 43");
  EXPECT_EQ(refusal<throw_in_a_long_frame>(play_scenario), "throws an exception in a fling, step 43");
}

TEST(ComparedCore, IsRefusedIfItChangesTheRounding) {
  EXPECT_EQ(refusal<do_nothing>(play_steps), "");
  const std::string reason = refusal<round_upward>(play_steps);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(reason,
            "changes how the processor computes (rounding mode, subnormals or trapped exceptions): found "
            "after a fling");
}

// Exceptions that have occurred change nothing.
TEST(ComparedCore, MayHaveInexactResults) { EXPECT_EQ(refusal<round_inexactly>(play_steps), ""); }

TEST(PlayWatch, NamesTheStepThatWasBegun) {
  PlayWatch watch{};
  watch.set_place("scenario a.json");
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.begin_call(40, 5);
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.updates = 2;
  EXPECT_EQ(watch.where(), "scenario a.json, step 42");
  watch.updates = 6;  // Not only those of the run.
  EXPECT_EQ(watch.where(), "scenario a.json");
  watch.set_place(std::string(500, 'a'));
  EXPECT_EQ(watch.where(), std::string(watch.place.size() - 1, 'a'));
}

}  // namespace
}  // namespace hyrax

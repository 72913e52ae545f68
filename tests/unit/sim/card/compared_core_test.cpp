#include "sim/card/compared_core.h"

#include <cfenv>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

using Step = void (*)();

void do_nothing() {}
void throw_an_exception() { throw std::runtime_error(""); }
void round_upward() { std::fesetround(FE_UPWARD); }
void round_inexactly() { std::feraiseexcept(FE_INEXACT | FE_UNDERFLOW); }

// Whose step does something else, and which names no constants.
template <Step kStep>
struct Doing : private physics {
  using physics::physics, physics::x, physics::y, physics::vx, physics::vy, physics::setPos,
      physics::setVelocity, physics::resetVelocity;
  void update(double, int, int, int, int) { kStep(); }
};

template <Step kStep>
std::string refusal() {
  PlayWatch watch{};
  const LibraryCore library{.counted = core_of<Doing<kStep>>(kPhysicsModel, {}),
                            .timed = {},
                            .lacking = "GRAVITY",
                            .defect = nullptr};
  EXPECT_FALSE(library.counted.constants);
  const ComparedCore compared = compared_core(1, library, {.why_incomplete = "not traced"}, watch);
  EXPECT_EQ(compared.core.constants->gravity_px_per_s2, 1200.0);
  try {
    static_cast<void>(compared.at("a fling").steps({}, 0.0, {}, 3));
  } catch (const CoreRefused& refusal) {
    EXPECT_EQ(refusal.core, 1);
    EXPECT_EQ(watch.core, 1);
    return refusal.what();
  }
  return "";
}

TEST(ComparedCore, IsRefusedIfItThrows) {
  EXPECT_EQ(refusal<throw_an_exception>(), "throws an exception in a fling");
}

TEST(ComparedCore, IsRefusedIfItChangesTheRounding) {
  EXPECT_EQ(refusal<do_nothing>(), "");
  const std::string reason = refusal<round_upward>();
  std::fesetround(FE_TONEAREST);
  EXPECT_TRUE(reason.starts_with("changes how the processor computes")) << reason;
}

// Exceptions that have occurred change nothing.
TEST(ComparedCore, MayHaveInexactResults) { EXPECT_EQ(refusal<round_inexactly>(), ""); }

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

// A smaller scenario keeps what the run says: how it ends, what is not finite, a rule of `expect` and its
// side, an invariant, other bits than the accepted core's. A core may end its process in any run.
#include "tools/app/search/shrink_run.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/stepper_of.h"
#include "sim/scenario/frame_clock.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/controlled_core.h"

namespace hyrax {
namespace {

using Trap = void (*)(State&);

// Straight on, until x is beyond the place of its trap.
struct TrappedStep {
  Trap trap = nullptr;
  double from_px = 0.0;
  void operator()(State& state, double dt_s, const Bounds&) const {
    state.x_px += state.vx_px_per_s * dt_s;
    if (state.x_px > from_px) trap(state);
  }
};

Core trapped(Trap trap, double from_px = 1000.0) {
  Core core;
  core.stepper =
      std::make_shared<const StepperOf<StepCores<TrappedStep>>>(StepCores<TrappedStep>{{trap, from_px}});
  return core;
}

Scenario long_fling() {
  return fling_at(60.0, 200, {{std::int64_t{5}, Place{{310.0, 400.0}}}, {std::int64_t{150}, Stop{}}});
}

class ShrinkRun : public testing::Test {
 protected:
  ShrunkRun shrunk(const Core& core, const Scenario& scenario, const ShrinkLimits& limits = {}) const {
    ShrunkRun run = shrink_run(core, folder_.at("scenarios/fling.json"), scenario, limits);
    EXPECT_TRUE(run.shrunk.fails_again);
    return run;
  }
  std::string refusal(const Core& core, const Scenario& scenario) const {
    const std::string message = refusal_of([&] { static_cast<void>(shrunk(core, scenario)); });
    return message.substr(std::min(message.size(), folder_.at("scenarios/fling.json").size()));
  }
  // A library in which the core is the accepted one.
  void accept(const Core& core) const {
    std::filesystem::create_directory(folder_.at("scenarios"));
    std::filesystem::create_directory(folder_.at("golden"));
    write_accepted_core(folder_.at("golden"), program_core(core));
  }

  const TempFolder folder_;
};

TEST_F(ShrinkRun, KeepsTheEndOfARunThatEndsItsProcess) {
  struct End {
    const char* kept;
    Trap trap;
  };
  for (const auto& [kept, trap] :
       {End{"signal 11 (SIGSEGV)", [](State&) { std::raise(SIGSEGV); }},
        End{"signal 8 (SIGFPE)", [](State&) { std::raise(SIGFPE); }},
        End{"ends the program", [](State&) { std::_Exit(0); }},
        End{"exception: beyond", [](State&) { throw std::out_of_range("beyond"); }}}) {
    const ShrunkRun run = shrunk(trapped(trap), long_fling());
    EXPECT_EQ(run.kept, kept);
    EXPECT_TRUE(run.shrunk.is_complete);
    const Scenario& left = run.shrunk.scenario;
    EXPECT_EQ(step_count(left), 1);
    EXPECT_EQ(left.events, std::vector<Event>());
    EXPECT_LE(complexity_of(left).digits, 8);
  }
}

// The row in which it does it is another in each run.
TEST_F(ShrinkRun, KeepsWhatACoreDoesThatEndsItsRun) {
  for (const auto& [kept, trap] :
       {std::pair<const char*, Trap>{"the core throws: beyond",
                                     [](State&) { throw std::out_of_range("beyond"); }},
        {"the core changes how the processor calculates (rounding or flush-to-zero); "
         "remove what sets it from the core",
         [](State&) { std::fesetround(FE_UPWARD); }}}) {
    const ShrunkRun run = shrunk(controlled(trapped(trap)), long_fling());
    EXPECT_EQ(run.kept, kept);
    EXPECT_EQ(step_count(run.shrunk.scenario), 1);
  }
  // As fuzz does it.
  const Core core = controlled(trapped([](State&) { throw std::out_of_range("beyond"); }));
  const Shrunk same = shrink_broken(core, long_fling(), {}, "the core throws: beyond");
  EXPECT_TRUE(same.fails_again);
  EXPECT_EQ(step_count(same.scenario), 1);
  EXPECT_FALSE(shrink_broken(core, long_fling(), {}, "the core throws: within").fails_again);
  EXPECT_FALSE(shrink_broken(core, long_fling(), Invariant::finite).fails_again);
}

TEST_F(ShrinkRun, KeepsThatARunDoesNotEnd) {
  const Core core = trapped([](State& state) {
    while (state.x_px > 0.0) static_cast<void>(getppid());
  });
  const ShrunkRun run = shrunk(core, long_fling(), {.search_s = 1.0, .run_s = 0.05});
  EXPECT_EQ(run.kept, "no end within 0.05 s");
  EXPECT_FALSE(run.shrunk.is_complete) << "the limit of the search";
  EXPECT_LT(step_count(run.shrunk.scenario), 200);
}

// The original does not stand still, as the roundest scenario would.
TEST_F(ShrinkRun, GoesOnWhereASimplerRunEndsTheProcess) {
  Scenario scenario = long_fling();
  scenario.expect.emplace().final_x_px = Interval{0.0, 400.0};
  const auto crash_if_still = [](State& state) {
    if (state.vx_px_per_s == 0.0 && state.x_px < 2000.0) std::raise(SIGSEGV);
  };
  const Core core = trapped(crash_if_still, 0.0);
  const ShrunkRun run = shrunk(core, scenario);
  EXPECT_EQ(run.kept, "final_x_px is above its range");
  EXPECT_NE(run.shrunk.scenario.start_velocity.vx_px_per_s, 0.0);
  EXPECT_EQ(step_count(run.shrunk.scenario), 1);
}

TEST_F(ShrinkRun, KeepsTheValueThatIsNotFinite) {
  const Core core = trapped([](State& state) {
    (state.vx_px_per_s > 3000.0 ? state.x_px : state.vy_px_per_s) = std::numeric_limits<double>::infinity();
  });
  const ShrunkRun run = shrunk(core, long_fling());
  EXPECT_EQ(run.kept, "vy becomes non-finite");
  EXPECT_LE(run.shrunk.scenario.start_velocity.vx_px_per_s, 3000.0) << "there, x becomes non-finite";
}

TEST_F(ShrinkRun, KeepsARuleOfExpectAndItsSideAndNoOtherRule) {
  Scenario scenario = fling_at(60.0, 200);
  Expect& expect = scenario.expect.emplace();
  expect.final_x_px = Interval{0.0, 1920.0};
  expect.state_hash = std::string(32, '0');
  expect.contacts.ground = Interval{9.0, 9.0};
  expect.contacts.right = Interval{9.0, 9.0};
  const ShrunkRun below = shrunk(shipped_core(), scenario);
  EXPECT_EQ(below.kept, "contacts/right is below its range");
  Expect left;
  left.contacts.right = Interval{9.0, 9.0};
  EXPECT_EQ(below.shrunk.scenario.expect, left);
  expect.contacts.right.reset();
  expect.contacts.ground = Interval{0.0, 1.0};
  const ShrunkRun above = shrunk(shipped_core(), scenario);
  EXPECT_EQ(above.kept, "contacts/ground is above its range");
  EXPECT_EQ(shrunk(shipped_core(), above.shrunk.scenario).shrunk.scenario, above.shrunk.scenario)
      << "it says so itself";
  scenario.expect.emplace().finite = false;
  EXPECT_EQ(shrunk(shipped_core(), scenario).kept, "finite is not false");
  scenario.expect.emplace().at_rest_since_s = Interval{0.0, 9.0};
  EXPECT_EQ(shrunk(shipped_core(), scenario).kept, "at_rest_since_s has no value");
}

TEST_F(ShrinkRun, KeepsAnInvariant) {
  const ShrunkRun run = shrunk(trapped([](State&) {}), long_fling());
  EXPECT_EQ(run.kept, "breaks in-bounds");
  EXPECT_EQ(step_count(run.shrunk.scenario), 1);
}

TEST_F(ShrinkRun, KeepsOtherBitsThanTheAcceptedCores) {
  accept(shipped_core());
  Constants constants = *shipped_core().constants;
  constants.gravity_px_per_s2 += 1.0;
  const Core core = listing_core(constants);
  const ShrunkRun run = shrunk(core, fling_at(60.0, 900));
  EXPECT_EQ(run.kept, "other bits than the accepted core's");
  EXPECT_EQ(step_count(run.shrunk.scenario), 1);
  EXPECT_EQ(
      refusal(shipped_core(), fling_at(60.0, 900)),
      ": nothing to keep: the run ends, stays finite, and breaks neither `expect` (state_hash aside) nor an "
      "invariant; the accepted core gives the same bits");
}

TEST_F(ShrinkRun, WithoutAnythingToKeepIsRefused) {
  Scenario scenario = fling_at(60.0, 9);
  scenario.expect.emplace().state_hash = std::string(32, '0');
  EXPECT_NE(refusal(shipped_core(), scenario)
                .find("there is no accepted core that can be played in " + folder_.at("golden/core")),
            std::string::npos);
}

}  // namespace
}  // namespace hyrax

// Contacts and rows of the paper's step, by cores that know nothing of it: those of the shipped core.
#include "sim/core/traced_core.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/core/contact_kernel.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/trace/recording.h"

namespace hyrax {
namespace {

void expect_the_runs_of_the_shipped_core(const Core& core) {
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    TraceSink shipped({.rows_every = 1000, .contacts = true, .blocks = true});
    TraceSink played({.rows_every = 1000, .contacts = true, .blocks = true});
    const std::string expected = text_of(replay(shipped_core(), scenario, shipped));
    ASSERT_EQ(text_of(replay(core, scenario, played)), expected) << path;
    ASSERT_TRUE(same_trace(played, shipped)) << path;
  }
}

// The shipped rows, their contacts told by this step, or without one by the rows.
TEST(ContactKernel, TellsTheContactsOfTheCoreByItsTracedStepAndByRowsThatAreThePapers) {
  for (const auto& step :
       {make_step_program(canonical(recording::record_listing())), std::shared_ptr<const StepProgram>()}) {
    Core core = shipped_core();
    core.kernel = std::make_shared<const ContactKernel>(core.kernel, step, core.constants);
    expect_the_runs_of_the_shipped_core(core);
  }
}

TEST(CompleteByStep, FindsTheConstantsThatTheClassGivesOtherNames) {
  Core core = shipped_core();
  core.constants.reset();
  complete_by_step(core);
  ASSERT_TRUE(core.constants);
  EXPECT_TRUE(same_bits(*core.constants, shipped_core().constants.value()));
}

// A spin, which no row shows, turns it.
struct SpinningBody : recording::Body {
  recording::Real spin = 3.0;
};

TEST(ContactKernel, TellsTheContactsOfAStepWithFurtherMembers) {
  const TracedStep step =
      canonical(recording::record_of<SpinningBody>([](SpinningBody& body, const recording::Frame& frame) {
        body.vx = body.vx + body.spin * frame.dt;
        body.spin = body.spin * recording::Real(0.5);
        recording::Listing()(body, frame);
      }));
  const std::optional<Core> core = traced_core(step);  // Knows its contacts.
  ASSERT_TRUE(core);
  Core told = *core;
  told.kernel = std::make_shared<const ContactKernel>(core->kernel, make_step_program(step), std::nullopt);
  const Event fling{std::int64_t{9'000}, Fling{{-1500.0, -900.0}}};
  for (const Scenario& scenario :
       {eventful_fling(), fling_at(60.0, 20'000), fling_at(60.0, 10'000, {fling})}) {
    TraceSink own, found;
    const std::string expected = text_of(replay(*core, scenario, own));
    EXPECT_EQ(text_of(replay(told, scenario, found)), expected);
    EXPECT_TRUE(same_trace(found, own));
  }
}

TEST(TracedCore, PlaysEveryScenarioAsTheShippedCoreDoes) {
  const std::optional<Core> core = traced_core(canonical(recording::record_listing()));
  ASSERT_TRUE(core);
  EXPECT_FALSE(core->constants);
  expect_the_runs_of_the_shipped_core(*core);
}

}  // namespace
}  // namespace hyrax

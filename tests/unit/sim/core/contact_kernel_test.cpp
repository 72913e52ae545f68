// Contacts of the paper's step, found by what knows nothing of it.
#include "sim/core/contact_kernel.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/trace/recording.h"

namespace hyrax {
namespace {

void expect_the_contacts_of_the_core(const std::shared_ptr<const StepProgram>& step) {
  Core by_kernel = shipped_core();
  by_kernel.kernel = std::make_shared<const ContactKernel>(by_kernel.kernel, step, by_kernel.constants);
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    TraceSink core({.rows_every = 1000, .contacts = true, .blocks = true});
    TraceSink told({.rows_every = 1000, .contacts = true, .blocks = true});
    const std::string expected = text_of(replay(shipped_core(), scenario, core));
    ASSERT_EQ(text_of(replay(by_kernel, scenario, told)), expected) << path;
    ASSERT_TRUE(same_trace(told, core)) << path;
  }
}

TEST(ContactKernel, TellsTheContactsOfTheCoreByItsTracedStep) {
  expect_the_contacts_of_the_core(make_step_program(canonical(recording::record_listing())));
}

TEST(ContactKernel, TellsThemByRowsThatAreThePapers) { expect_the_contacts_of_the_core(nullptr); }

}  // namespace
}  // namespace hyrax

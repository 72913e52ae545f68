// The traced step of the paper's listing, interpreted: the rows and contacts of the shipped core.
#include "sim/replay/traced_kernel.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/replay/replay.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/trace/recording.h"

namespace hyrax {
namespace {

TEST(TracedKernel, PlaysEveryScenarioAsTheShippedCoreDoes) {
  const auto kernel = make_traced_kernel(canonical(recording::record_listing()));
  ASSERT_TRUE(kernel);
  EXPECT_FALSE(kernel->constants());
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    TraceSink shipped({.rows_every = 1000, .contacts = true, .blocks = true});
    TraceSink traced({.rows_every = 1000, .contacts = true, .blocks = true});
    const std::string expected = text_of(replay(scenario, shipped));
    ASSERT_EQ(text_of(replay(scenario, traced, {.kernel = kernel.get()})), expected) << path;
    ASSERT_TRUE(same_trace(traced, shipped)) << path;
  }
}

TEST(TracedKernel, IsOfFourMembers) {
  TracedStep step = recording::record_listing();
  step.members.push_back(NumberKind::real);
  for (std::vector<StepPath>& paths : step.paths)
    for (StepPath& path : paths) path.members.push_back(path.members.front());
  EXPECT_FALSE(make_traced_kernel(canonical(step)));
}

}  // namespace
}  // namespace hyrax

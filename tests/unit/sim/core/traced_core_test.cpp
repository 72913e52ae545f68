// The traced step of the paper's listing, interpreted: the rows and contacts of the shipped core.
#include "sim/core/traced_core.h"
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

TEST(TracedCore, PlaysEveryScenarioAsTheShippedCoreDoes) {
  const std::optional<Core> core = traced_core(canonical(recording::record_listing()));
  ASSERT_TRUE(core);
  EXPECT_FALSE(core->constants);
  for (const std::string& path : scenario_files()) {
    const Scenario scenario = load_scenario(path);
    TraceSink shipped({.rows_every = 1000, .contacts = true, .blocks = true});
    TraceSink traced({.rows_every = 1000, .contacts = true, .blocks = true});
    const std::string expected = text_of(replay(shipped_core(), scenario, shipped));
    ASSERT_EQ(text_of(replay(*core, scenario, traced)), expected) << path;
    ASSERT_TRUE(same_trace(traced, shipped)) << path;
  }
}

// One that no function of the step reads.
TEST(TracedCore, KeepsItsFurtherMembers) {
  TracedStep step = recording::record_listing();
  step.members.push_back(NumberKind::real);
  for (std::vector<StepPath>& paths : step.paths)
    for (StepPath& path : paths) path.members.push_back(path.members.front());
  const std::optional<Core> core = traced_core(canonical(step));
  ASSERT_TRUE(core);
  for (const Scenario& scenario : {eventful_fling(), fling_at(60.0, 20'000)})
    EXPECT_EQ(replay(*core, scenario).state_hash, replay(shipped_core(), scenario).state_hash);
}

}  // namespace
}  // namespace hyrax

// Every study, in its smallest form, of cores with other constants than the paper's.
#include <gtest/gtest.h>

#include "sim/core/listing_core.h"
#include "sim/study/study.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/study/clocks.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

// All rules hold; what a scenario expects of the paper's constants is left out.
void expect_every_study_follows(const Constants& constants, const std::string& hard_scenarios) {
  Core core = listing_core(constants);
  core.name = "mine/1";
  for (const Study& study : studies()) {
    StudyRequest request{.core = core,
                         .is_quick = true,
                         .machine = "m",
                         .measure_costs = [](const Works& works, const CostOptions&) {
                           return metered<steady_ns>(works, {.processes = 1, .rounds = 1});
                         }};
    if (study.name == "needs") request.scenarios = {{"fling.json", fling_at(60.0, 600)}};
    if (study.name == "hard-cases")
      for (const std::string& path : scenario_files())
        if (path.find(hard_scenarios) != std::string::npos) {
          request.scenarios.push_back({path, load_scenario(path)});
          request.scenarios.back().scenario.expect.reset();
        }
    EXPECT_EQ(study.run(request).verdict.broken, std::vector<std::string>{})
        << study.name << ", gravity " << constants.gravity_px_per_s2;
  }
}

TEST(OtherConstants, EveryStudyFollowsThem) {
  expect_every_study_follows({980.0, 0.9, 0.9995, 0.7, 8.0}, "/hard/r");
}

TEST(OtherConstants, DISABLED_EveryStudyFollowsFurtherOnesInAllScenarios) {
  for (const Constants& constants :
       {Constants{980.0, 0.9, 0.9995, 0.7, 8.0}, {500.0, 1.0, 1.0, 0.8, 5.0}, {9.81, 0.3, 0.99, 1.0, 0.01}})
    expect_every_study_follows(constants, "/hard/");
}

}  // namespace
}  // namespace hyrax

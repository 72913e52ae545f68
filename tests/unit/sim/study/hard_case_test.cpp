// Cases, their families, and what is said of them.
#include <gtest/gtest.h>

#include <set>

#include "sim/study/hard_case_table.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

Scenario named(const std::string& name) {
  Scenario scenario = load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/hard/" + name + ".json");
  return scenario;
}

TEST(HardCase, AScenarioOfTheUsersOwnIsOneCase) {
  const std::vector<HardCase> cases = hard_cases_of(fling_at(60.0, 100));
  ASSERT_EQ(cases.size(), 1u);
  EXPECT_TRUE(cases[0].findings.empty());
}

TEST(HardCase, MembersOfAFamilyHaveNamesOfTheirOwnAndKeepTheLimits) {
  std::set<std::string> names;
  for (const std::string& path : scenario_files()) {
    if (path.find("/hard/") == std::string::npos) continue;
    for (const HardCase& hard_case : hard_cases_of(load_scenario(path))) {
      EXPECT_TRUE(names.insert(hard_case.name).second) << hard_case.name;
      EXPECT_FALSE(hard_case.why.empty()) << hard_case.name;
      EXPECT_TRUE(std::is_sorted(hard_case.scenario.events.begin(), hard_case.scenario.events.end(),
                                 [](const Event& a, const Event& b) {
                                   return std::get<std::int64_t>(a.when) < std::get<std::int64_t>(b.when);
                                 }))
          << hard_case.name;
    }
  }
  EXPECT_GE(names.size(), 50u);
}

TEST(HardCase, AScenarioOfAnotherFormThatBearsAFamilysNameIsOneCase) {
  for (const char* const name : {"grazing", "any-jitter", "a-fling-a-minute", "trace-of-extremes", "rest"}) {
    Scenario scenario = fling_at(60.0, 0);
    scenario.name = name;
    scenario.clock.base = FixedStep{0.01};
    scenario.length = 0.5;
    EXPECT_EQ(hard_cases_of(scenario).size(), 1u) << name;
    scenario.clock.base = FixedRate{60.0};
    scenario.events = {{0.1, Stop{}}};
    EXPECT_EQ(hard_cases_of(scenario).size(), 1u) << name;
  }
}

TEST(HardCase, AFindingIsNoBreachAndAFindingThatIsGoneIsOne) {
  HardCase hard_case{
      .name = "case", .made_from = "case", .why = "", .scenario = fling_at(60.0, 200), .findings = {}};
  const HardCaseResult result = play_hard_case(hard_case);
  EXPECT_EQ(judge(hard_case, result, Invariant::mirror), CaseVerdict::held);
  hard_case.findings = {{Invariant::mirror, "known"}};
  EXPECT_EQ(judge(hard_case, result, Invariant::mirror), CaseVerdict::finding_gone);
  EXPECT_EQ(broken_sentences({{hard_case, result}}).size(), 1u);
}

TEST(HardCase, DragInAFrameOfNoTimeIsAFindingInAScenarioOfTheUsersOwn) {
  const HardCase hard_case{.name = "case",
                           .made_from = "case",
                           .why = "",
                           .scenario = fling_at(60.0, 60, {{std::int64_t{20}, Hitch{0.0}}}),
                           .findings = {}};
  EXPECT_EQ(judge(hard_case, play_hard_case(hard_case), Invariant::no_time), CaseVerdict::finding);
}

TEST(HardCase, AnExpectationThatDoesNotHoldIsNamed) {
  HardCase hard_case{
      .name = "case", .made_from = "case", .why = "", .scenario = fling_at(60.0, 200), .findings = {}};
  hard_case.scenario.expect.emplace().final_x_px = Interval{-2.0, -1.0};
  const HardCaseResult result = play_hard_case(hard_case);
  EXPECT_EQ(judge(hard_case, result, Invariant::expectations), CaseVerdict::broken);
  EXPECT_EQ(broken_sentences({{hard_case, result}}),
            std::vector<std::string>{"case: expectations: final_x_px: wanted -2 .. -1"});
}

TEST(HardCase, BoundsOfErrorsAreExpectationsToo) {
  HardCase hard_case{
      .name = "case", .made_from = "case", .why = "", .scenario = fling_at(60.0, 200), .findings = {}};
  Expect& expect = hard_case.scenario.expect.emplace();
  expect.implementation_px_max = 1e-6;
  EXPECT_EQ(judge(hard_case, play_hard_case(hard_case), Invariant::expectations), CaseVerdict::held);
  for (std::optional<double> Expect::*const bound :
       {&Expect::implementation_px_max, &Expect::truncation_px_max, &Expect::energy_drift_rel_max}) {
    expect = {};
    expect.*bound = 0.0;
    EXPECT_EQ(judge(hard_case, play_hard_case(hard_case), Invariant::expectations), CaseVerdict::broken);
  }
}

TEST(HardCase, TablesHaveARowForEveryInvariantAsked) {
  std::vector<PlayedCase> played;
  for (HardCase& hard_case : hard_cases_of(named("corners"))) {
    const HardCaseResult result = play_hard_case(hard_case);
    played.push_back({std::move(hard_case), result});
  }
  std::int64_t asked = 0;
  for (std::size_t index = 0; index < kInvariantCount; ++index)
    asked += summarise(played, static_cast<Invariant>(index)).asked;
  EXPECT_EQ(row_count(hard_case_verdicts(played)), static_cast<std::size_t>(asked));
  EXPECT_EQ(row_count(hard_case_list(played)), played.size());
}

}  // namespace
}  // namespace hyrax

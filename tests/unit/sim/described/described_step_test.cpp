#include "sim/described/described_step.h"
#include "sim/described/interpreted_core.h"

#include <gtest/gtest.h>

#include "core_for_test.h"
#include "sim/trace/step_text.h"

namespace hyrax {
namespace {

struct Sled {
  double x = 1.0, v = 2.0;
  bool is_far = false;
  void step(double dt_s) {
    x += v * dt_s;
    is_far = x > 100;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("v_px_per_s", v);
  }
  void actions(auto&& see) {
    see("push", [&](double by) { v += by; }, {"by_px_per_s"});
  }
  void contacts(auto&& see) const { see("far", is_far); }
};

// As recorded, then changed by `alter`.
DescribedStep step_of_sled(
    const std::function<void(TracedStep&)>& alter = [](TracedStep&) {}, bool is_checked = true) {
  constexpr NumberKind kReal = NumberKind::real, kWhole = NumberKind::whole;
  const auto argument = [](const char* name) {
    return Expression{.op = Operator::argument, .kind = NumberKind::real, .name = name};
  };
  TracedStep step{
      .members = {kReal, kReal, kWhole},
      .expressions = {argument("x_px"), argument("v_px_per_s"), argument("dt"), argument("push(by_px_per_s)"),
                      Expression{.value = 100.0}, Expression{.kind = kWhole, .value = 0.0},
                      Expression{.kind = kWhole, .value = 1.0},
                      Expression{.op = Operator::multiply, .operands = {1, 2, kNoIndex}},
                      Expression{.op = Operator::add, .operands = {0, 7, kNoIndex}},
                      Expression{.op = Operator::add, .operands = {1, 3, kNoIndex}}},
      .comparisons = {{4, 8, Relation::less}},
      .paths = {{{{{0, false}}, {8, 1, 5}}, {{{0, true}}, {8, 1, 6}}}, {{{}, {0, 9, 5}}}},
      .member_names = {"x_px", "v_px_per_s", "far"},
      .function_names = {"step", "push(by_px_per_s)"}};
  alter(step);
  const std::string text = step_text(canonical(step));
  DescribedCore core = core_for_test<Sled>();
  core.record.step = text;
  return is_checked ? described_step(core) : DescribedStep{read_step(text)};
}

TEST(DescribedStep, IsHeldToTheCompiledCore) {
  const DescribedStep step = step_of_sled();
  EXPECT_EQ(step.why_incomplete, "");
  ASSERT_TRUE(step.step);
  EXPECT_EQ(step.step->paths[0].size(), 2U);
}

// Rows, events, contacts and a hold, from a start that a scenario sets.
TEST(DescribedStep, InterpretedItPlaysScenariosBitForBit) {
  const DescribedCore core = core_for_test<Sled>();
  DescribedScenario scenario = scenario_for_test(200);
  scenario.start = {{0, word_of(40.5)}};
  scenario.events = {event_for_test(30, Act{0, {word_of(55.25)}}), event_for_test(40, Hold{}),
                     event_for_test(45, SetValues{{}, {{0, word_of(70.0)}}}), event_for_test(50, Go{})};
  const auto hash = [&](const DescribedCore& played) { return play(played, scenario, {}).state_hash; };
  EXPECT_GT(play(core, scenario, {}).contacts[0], 0);
  EXPECT_EQ(hash(interpreted(core, *step_of_sled().step)), hash(core));
  const auto with_wall = [](TracedStep& step) { step.expressions[4].value = 110.0; };
  EXPECT_NE(hash(interpreted(core, *step_of_sled(with_wall, false).step)), hash(core)) << "the control";
}

TEST(DescribedStep, IsNotCompleteWhereABitDiffers) {
  constexpr auto kDiffers = "the traced step does not give the compiled core's bits: ";
  const auto why = [](const auto& alter) { return step_of_sled(alter).why_incomplete; };
  EXPECT_EQ(why([](TracedStep& step) {
              step.expressions[8].operands = {0, 2, kNoIndex};
            }),
            std::string(kDiffers) + "step makes another x_px");
  EXPECT_EQ(why([](TracedStep& step) { step.expressions[4].value = 100.5; }),
            std::string(kDiffers) + "step makes another far");
  EXPECT_EQ(why([](TracedStep& step) { step.paths[1][0].members[1] = 1; }),
            std::string(kDiffers) + "push(by_px_per_s) makes another v_px_per_s");
  EXPECT_EQ(why([](TracedStep& step) { step.expressions[0].name = step.member_names[0] = "y_px"; }),
            std::string(kDiffers) + "push(by_px_per_s) makes another y_px");
  EXPECT_EQ(
      why([](TracedStep& step) {
        step.expressions[9] = {.op = Operator::call, .operands = {1, kNoIndex, kNoIndex}, .name = "lgamma"};
      }),
      std::string(kDiffers) + "push(by_px_per_s) makes another v_px_per_s");
}

TEST(DescribedStep, IsNotCompleteWhereTheBuildSaysSo) {
  DescribedCore core = core_for_test<Sled>();
  core.record.why_incomplete = "more than 32 values";
  EXPECT_EQ(described_step(core).why_incomplete, "more than 32 values");
  EXPECT_FALSE(described_step(core).step);
}

}  // namespace
}  // namespace hyrax

// A measured run as its text, its members and its picture.
#include <gtest/gtest.h>

#include <regex>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/app/drift/drift.h"
#include "tools/report/drift_figure.h"
#include "tools/report/figure_svg.h"

namespace hyrax {
namespace {

std::string text_of(const DriftReport& report, bool lists_all) {
  const Result result = drift_result(report, lists_all);
  std::string text = described(result.verdict) + "members\n";
  for (const Table& table : result.summary) text += described(table, "  ");
  return text;
}

std::string picture_of(const DriftRun& run) {
  const Figure figure = drift_figure(run);
  EXPECT_EQ(picture_faults(figure_svg(figure)), std::vector<std::string>{}) << figure.title;
  return described(figure);
}

TEST(DriftRows, OfALongFlightAreEvenlyApart) {
  const DriftRun run =
      measure_drift(shipped_core(), fling_at(10'000.0, 9'000), {.gsl = {}, .keeps_rows = true});
  ASSERT_GT(run.rows.size(), kRowsDrawnMax / 2);
  for (std::size_t row = 1; row < run.rows.size(); ++row)
    EXPECT_EQ(run.rows[row].errors.step - run.rows[row - 1].errors.step, 4);
  ASSERT_GT(run.whole_rows.size(), kRowsDrawnMax / 2);
  for (std::size_t row = 1; row < run.whole_rows.size(); ++row)
    EXPECT_NEAR(run.whole_rows[row].t_s - run.whole_rows[row - 1].t_s, 4e-4, 1e-9);
}

TEST(DriftResult, OfRunsAreThoseApproved) {
  std::string text = "A run with everything\n";
  DriftReport report{
      .run = measure_drift(shipped_core(), eventful_fling(), {.gsl = GslOptions{}, .keeps_rows = true}),
      .has_rows_stored = true,
      .half_dt = HalfDt{.run = measure_drift(shipped_core(), fling_at(120.0, 40))}};
  report.half_dt->run->scenario.length = std::int64_t{660};
  text += text_of(report, false) + picture_of(report.run);

  text += "\nA long one, all of it listed\n";
  std::vector<Event> flings;
  for (std::int64_t frame = 5; frame < 200; frame += 5) flings.push_back({frame, Fling{{10.0, -100.0}}});
  report = {.run = measure_drift(shipped_core(), fling_at(60.0, 200, flings))};
  report.half_dt = HalfDt{.why_not = "a reason"};
  const std::string shortened = text_of(report, false);
  EXPECT_NE(shortened.find("  ... 20 more; --verbose lists them\n"), std::string::npos) << shortened;
  text += described(drift_result(report, true).verdict);

  text += "\nNo flight\n";
  report = {.run = measure_drift(shipped_core(), fling_at(60.0, 1))};
  text += text_of(report, false) + picture_of(report.run);

  text += "\nBounces, and faults\n";
  report = {.run = measure_drift(shipped_core(), fling_at(60.0, 300), {.gsl = {}, .keeps_rows = true})};
  text += picture_of(report.run);
  report.run.note = "a note";
  report.run.whole.run->end_px = 12.0;
  report.run.summary.differing_steps = 2;
  report.run.summary.non_finite_step = 7;
  report.run.summary.reference_faults = 1;
  report.run.summary.first_reference_fault_step = 3;
  report.run.summary.first_reference_fault = "a fault";
  text += text_of(report, false);
  EXPECT_EQ(drift_exit_code(report.run), ExitCode::program_fault);
  expect_approved("tests/unit/tools/app/drift.txt",
                  std::regex_replace(text, std::regex("[0-9.]+e-1[0-9]+"), "rounding"));
}

// A frame's dt is halved, a hitch's is not.
TEST(HalfDt, IsOfTheRunWithTwiceTheFramesAndItsInputsAtTheirTimes) {
  const auto fling = [](double rate_hz, std::int64_t frames) {
    return fling_at(rate_hz, 90 * frames,
                    {{40 * frames, Hitch{0.05}}, {50 * frames, Fling{{-1500.0, -900.0}}}, {1.005, Stop{}}});
  };
  Scenario halved = fling(120.0, 2), scenario = fling(60.0, 1);
  halved.events.back().when = std::int64_t{118};
  const DriftRun wanted = measure_drift(shipped_core(), halved);
  for (const Clock& clock : {Clock{FixedRate{60.0}, {}}, Clock{FixedStep{1.0 / 60.0}, {}}}) {
    scenario.clock = clock;
    const DriftRun half = measure_half_dt(shipped_core(), scenario).run.value();
    EXPECT_EQ(half.steps, 180);
    EXPECT_EQ(half.summary.model_px->value, wanted.summary.model_px->value);
    EXPECT_EQ(half.longest_arc->last_step, wanted.longest_arc->last_step);
  }
}

TEST(HalfDt, SaysWhyItIsNotMeasured) {
  for (const auto& [clock, steps, why_not] :
       std::initializer_list<std::tuple<Clock, std::int64_t, const char*>>{
           {{FixedRate{60.0}, Jitter{Jitter::Kind::uniform, 0.1, 1}}, 9, "jitter"},
           {{RecordedSteps{{0.1, 0.2}}, {}}, 2, "a trace"},
           {{FixedStep{0.0}, {}}, 9, "dt is 0"},
           {{FixedRate{60.0}, {}}, 0, "dt is 0"},
           {{FixedRate{60.0}, {}}, 1'000'001, "over 1e6 steps"},
           {{FixedRate{0.6 * kRateMax_hz}, {}}, 9, "no such clock"}}) {
    Scenario scenario = fling_at(60.0, steps);
    scenario.clock = clock;
    const HalfDt half = measure_half_dt(shipped_core(), scenario);
    EXPECT_FALSE(half.run.has_value());
    EXPECT_EQ(half.why_not, why_not);
  }
}

// What half the error costs: by the order of the truncation error; the model error stays where drag is the
// reason.
TEST(HalfError, SaysWhatHoldsOfThisCoreAndScenario) {
  const auto said = [](const Core& core, const Scenario& scenario) {
    const DriftReport report{.run = measure_drift(core, scenario),
                             .half_dt = measure_half_dt(core, scenario)};
    const std::string text = described(drift_result(report, false).verdict);
    const std::string line = text.substr(text.find("half the error"));
    return line.substr(0, line.find("\n  brief: "));
  };
  Constants constants = *shipped_core().constants;
  constants.air_drag = 1.0;
  Core dragless = listing_core(constants);
  dragless.name = "dragless/1";
  Scenario hitch = fling_at(60.0, 100, {{std::int64_t{20}, Hitch{0.5}}});
  hitch.start_velocity = {600.0, -700.0};
  EXPECT_TRUE(std::regex_match(
      said(shipped_core(), fling_at(60.0, 100)),
      std::regex(R"(half the error costs [12]\.\d times the steps \(120 Hz\)\s+the model error then )"
                 R"(is \S+ px: drag acts once a frame, however short)")))
      << said(shipped_core(), fling_at(60.0, 100));
  EXPECT_EQ(said(dragless, fling_at(60.0, 100)), "half the error costs 2.0 times the steps (120 Hz)");
  EXPECT_TRUE(said(dragless, hitch).starts_with("half the error: not by shorter frames; truncation "));
  EXPECT_EQ(said(shipped_core(), hitch).find("drag"), std::string::npos);
}

TEST(MarginText, NeverPromisesMoreThanTheMargin) {
  Margin margin{.half_width = 0.01999, .nearest = NearestDecision{}};
  EXPECT_TRUE(margin_text(margin).starts_with("any start within ±0.019 px and px/s keeps all contacts; "));
  margin.half_width = 1e-9;
  EXPECT_FALSE(is_knife_edge(margin));
  margin.half_width = 0.99e-9;
  EXPECT_TRUE(is_knife_edge(margin));
  EXPECT_EQ(margin_text({}), "no start changes the contacts");
}

}  // namespace
}  // namespace hyrax

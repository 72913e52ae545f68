// Cases, their families and their verdicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/scenario/split_mix64.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/study.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {
namespace {

Scenario named(const std::string& name) {
  return load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/hard/" + name + ".json");
}

HardCase case_of(const Scenario& scenario) { return hard_cases_of(shipped_core(), scenario).front(); }

CaseVerdict judged(const HardCase& hard_case, Invariant invariant) {
  return judge(play_hard_case(shipped_core(), hard_case), invariant);
}

const Study& hard_cases() {
  for (const Study& study : studies())
    if (study.name == "hard-cases") return study;
  throw std::logic_error("no study hard-cases");
}

Result studied(std::vector<Scenario> scenarios, const Core& core = shipped_core()) {
  StudyRequest request{.core = core};
  for (Scenario& scenario : scenarios) request.scenarios.push_back({"some.json", std::move(scenario)});
  return hard_cases().run(request);
}

// Hash of a family's names, reasons and scenarios (the first 50 events of each).
std::string digest_of(std::span<const HardCase> family) {
  std::string text;
  for (const HardCase& hard_case : family) {
    Scenario scenario = hard_case.scenario;
    scenario.description.reset();
    scenario.events.resize(std::min<std::size_t>(scenario.events.size(), 50));
    text += hard_case.name + hard_case.why + std::to_string(hard_case.must_come_to_rest) +
            hard_case.never_at_rest + hard_case.thrown_at_rest + std::to_string(hard_case.is_long) +
            scenario_file_text(scenario);
  }
  std::uint64_t digest = 0;
  for (const char letter : text) digest = split_mix64(digest, static_cast<unsigned char>(letter));
  return fmt::format("{:08x}", digest >> 32);
}

// Each scenario of the library has the family that it was written for, and no other, whatever its name.
TEST(HardCase, FamiliesAreChosenByWhatAScenarioDoes) {
  const std::map<std::string, std::pair<std::size_t, std::string>> families = {
      {"a-fling-a-minute", {43, "3ea0b739"}},
      {"any-frame", {14, "9b6bc4d8"}},
      {"any-jitter", {15, "77eeb2f8"}},
      {"any-speed", {13, "f3ed6f42"}},
      {"corners", {17, "0ad2d2ad"}},
      {"far-outside", {13, "a630440f"}},
      {"grazing", {8, "434e4e4c"}},
      {"hitch", {16, "c5ca7132"}},
      {"on-a-bound", {13, "33e67621"}},
      {"rest", {28, "6810461f"}},
      {"ten-million-steps", {2, "88818acc"}},
      {"trace-of-extremes", {2, "35074bcd"}},
      {"zeno", {4, "7415d0f0"}}};
  std::size_t families_found = 0;
  for (const std::string& path : scenario_files()) {
    if (path.find("/hard/") == std::string::npos) continue;
    SCOPED_TRACE(path);
    Scenario scenario = load_scenario(path);
    const auto family = families.find(scenario.name);
    families_found += family != families.end() ? 1 : 0;
    scenario.name = family == families.end() ? families.begin()->first : "renamed";
    const std::vector<HardCase> cases = hard_cases_of(shipped_core(), scenario);
    EXPECT_EQ(std::pair(cases.size(), digest_of(std::span(cases).subspan(1))),
              family == families.end() ? std::pair(std::size_t{1}, std::string("00000000")) : family->second);
    EXPECT_FALSE(cases.front().why.empty());
  }
  EXPECT_EQ(families_found, families.size());
}

TEST(HardCase, ExpectedFailuresAreThoseOfWhatAScenarioDoes) {
  for (const char* const name :
       {"subnormal-speed", "sprite-far-larger-than-window", "sprite-higher-than-window"}) {
    Scenario scenario = named(name);
    scenario.name = "renamed";
    if (std::holds_alternative<double>(scenario.length)) scenario.length = std::int64_t{4'000};
    EXPECT_EQ(judged(case_of(scenario), Invariant::comes_to_rest), CaseVerdict::expected_failure) << name;
  }
}

TEST(HardCase, ThatDoesMoreOrLessThanAFamilyIsOneCase) {
  std::vector<Scenario> others(6, fling_at(60.0, 10'000, {{std::int64_t{10}, Stop{}}}));
  others[0].clock.jitter = Jitter{Jitter::Kind::uniform, 0.1, 1};
  others[1].clock.jitter = others[2].clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.1, 1};
  others[2].events.clear();
  others[3].start_velocity = {};
  others[3].start.y_px = 952.0;
  others[4].events = {{std::int64_t{10}, Hitch{0.1}}};  // It does not land.
  others[4].window.height_px = 1'000'000;
  others[5].events.clear();  // Into the right wall, far from a corner.
  others[5].start.x_px = 1782.0;
  others[5].start_velocity = {900.0, 900.0};
  for (std::size_t each = 0; each < others.size(); ++each)
    EXPECT_EQ(hard_cases_of(shipped_core(), others[each]).size(), 1u) << each;
}

// Of other heights, rates and lengths, too, the shipped core passes the gate.
TEST(HardCase, AnyDropHoldsWhatItsFamilyAsks) {
  for (const double y_px : {0.0, 951.0})
    for (const double rate_hz : {30.0, 144.0})
      for (const double duration_s : {1.0, 15.0}) {
        Scenario scenario = named("rest");
        scenario.expect.reset();
        scenario.start.y_px = y_px;
        scenario.clock.base = FixedRate{rate_hz};
        scenario.length = duration_s;
        const std::vector<HardCase> cases = hard_cases_of(shipped_core(), scenario);
        EXPECT_EQ(cases.size(), duration_s < 2.0  ? 1u
                                : rate_hz < 100.0 ? 28u
                                                  : 4u)
            << y_px << ", " << rate_hz;
        if (cases.size() != 4u) continue;  // 28 take long.
        EXPECT_EQ(studied({scenario}).verdict.broken, std::vector<std::string>{})
            << y_px << " px, " << rate_hz << " Hz";
      }
}

TEST(HardCase, TheGateBreaksByWhatIsBrokenAndByAnExpectedFailureThatDoesNotOccur) {
  Scenario sliding = named("subnormal-speed");
  sliding.length = std::int64_t{4'000};
  EXPECT_EQ(studied({sliding}).verdict.broken, std::vector<std::string>{});
  Constants lively = *shipped_core().constants, rough = lively;
  rough.ground_friction = 0.0;
  Core sticky = listing_core(rough);  // Not what its constants say.
  sticky.constants = lively;
  EXPECT_EQ(studied({sliding}, sticky).verdict.broken.back(),
            "subnormal-speed: comes-to-rest holds: its expected failure is out of date");
  lively.restitution = 1.5;
  const std::vector<std::string> broken = studied({fling_at(60.0, 200)}, listing_core(lively)).verdict.broken;
  ASSERT_EQ(broken.size(), 3u);
  EXPECT_EQ(
      broken[1],
      "fling: energy-ceiling is broken by 7.42e+06 px²/s² in row 196 (energy never above that after the "
      "last input, or of residual speed)");
}

// At the left wall it passes 0 by 2e-15 px; its mirror image does not pass 1792.
TEST(HardCase, TheStudySaysHowOftenRoundingAloneDecided) {
  Scenario edge = fling_at(60.0, 20);
  edge.start = {std::nextafter(0.999 * 600.0 * (1.0 / 60.0), 0.0), 300.0};
  edge.start_velocity = {-600.0, 0.0};
  const Result result = studied({edge});
  EXPECT_EQ(std::get<std::string>(result.verdict.text.at(2)),
            "  rounding alone decided 1 time whether a wall was met");
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(result.tables[1].columns[4].values),
            std::vector<std::int64_t>{1});
}

TEST(HardCase, BouncesWithoutLossGainNoEnergyAndLoseItAtSomeRates) {
  std::map<CaseVerdict, int> verdicts;
  for (HardCase& hard_case : hard_cases_of(shipped_core(), named("a-fling-a-minute"))) {
    if (!hard_case.is_lossless) continue;
    const PlayedCase played = play_hard_case(shipped_core(), std::move(hard_case));
    for (const Invariant broken : broken_invariants(played.hard_case.scenario, played.measures))
      EXPECT_EQ(broken, Invariant::keeps_energy) << played.hard_case.name;
    ++verdicts[judge(played, Invariant::keeps_energy)];
  }
  EXPECT_EQ(verdicts,
            (std::map<CaseVerdict, int>{{CaseVerdict::held, 36}, {CaseVerdict::expected_failure, 4}}));
}

// Also with other laws, as far as there is an exact fling.
TEST(HardCase, TheExactFlingMeetsBothWallsOfACornerAtOneTime) {
  const auto members = [](const Constants& laws) {
    std::map<CaseVerdict, int> verdicts;
    Core core = listing_core(laws);
    core.name = "own";
    for (HardCase& hard_case : hard_cases_of(core, named("corners")))
      if (hard_case.exact_corner != 0)
        ++verdicts[judge(play_hard_case(core, std::move(hard_case)), Invariant::exact_corner)];
    return verdicts;
  };
  using Verdicts = std::map<CaseVerdict, int>;
  for (const Constants& laws :
       {Constants{1200.0, 0.6, 0.999, 0.8, 5.0}, Constants{980.0, 0.9, 0.9995, 0.7, 8.0},
        Constants{1e5, 0.0, 0.5, 1.0, 1.0}, Constants{1.0, 1.0, 1.0, 1.0, 5.0}})
    EXPECT_EQ(members(laws), (Verdicts{{CaseVerdict::held, 4}}));
  EXPECT_EQ(members({0.0, 0.6, 0.999, 0.8, 5.0}), Verdicts());
}

// Makes every difference of vx four times as large in each step: that of an ulp is one of a pixel before
// long.
struct Growing : StepperOver {
  using StepperOver::StepperOver;
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    State after = StepperOver::steps(body, dt_s, bounds, steps);
    after.vx_px_per_s = std::remainder(4.0 * after.vx_px_per_s, 4e4);
    return after;
  }
};

TEST(HardCase, ContactsOfStartsAnUlpApartPartByAChaoticCoreAlone) {
  const auto texts = [](const Table& table, std::size_t column) {
    return std::get<std::vector<std::string>>(table.columns[column].values);
  };
  const std::vector<std::string> paper = texts(parting_table(shipped_core()), 2);
  EXPECT_EQ(paper[0], "0 of 100 flings (0 .. 4 %)");
  EXPECT_EQ(paper[3], "17 of 100 flings (11 .. 26 %)");
  EXPECT_EQ(paper[4], "0 of 100 flings (0 .. 4 %)");
  EXPECT_EQ(paper[7], "35 of 100 flings (26 .. 45 %)");
  Core growing = shipped_core();
  growing.stepper = std::make_shared<Growing>(growing.stepper);
  const Table table = parting_table(growing);
  EXPECT_EQ(texts(table, 2)[0], "99 of 100 flings (95 .. 100 %)");
  EXPECT_EQ(texts(table, 3)[0], "0.6 (0.6 .. 0.7)");
  EXPECT_EQ(texts(table, 4)[0], "3 (2 .. 3)");
}

TEST(HardCase, DragInAZeroLengthFrameIsAnExpectedFailureInEveryScenario) {
  const HardCase hard_case = case_of(fling_at(60.0, 60, {{std::int64_t{20}, Hitch{0.0}}}));
  EXPECT_EQ(judged(hard_case, Invariant::no_time), CaseVerdict::expected_failure);
}

TEST(HardCase, ALongFrameThrowsASpriteAtRestWhichUnevenOnesDoNot) {
  std::map<std::string, CaseVerdict> verdicts;
  for (const char* const name : {"hitch", "rest"})
    for (HardCase& hard_case : hard_cases_of(shipped_core(), named(name)))
      if (hard_case.rests_from_s) verdicts[hard_case.name] = judged(hard_case, Invariant::stays_at_rest);
  EXPECT_EQ(verdicts,
            (std::map<std::string, CaseVerdict>{{"hitch/at-rest-0.5-s", CaseVerdict::expected_failure},
                                                {"hitch/at-rest-3600-s", CaseVerdict::expected_failure},
                                                {"hitch/at-rest-28800-s", CaseVerdict::expected_failure},
                                                {"rest/uneven-uniform", CaseVerdict::held},
                                                {"rest/uneven-normal", CaseVerdict::held},
                                                {"rest/uneven-missed", CaseVerdict::held}}));
}

TEST(HardCase, BoundsOfErrorsAreExpectationsToo) {
  HardCase hard_case = case_of(fling_at(60.0, 200));
  Expect& expect = hard_case.scenario.expect.emplace();
  expect.implementation_px_max = 1e-6;
  EXPECT_EQ(judged(hard_case, Invariant::expectations), CaseVerdict::held);
  for (std::optional<double> Expect::*const bound :
       {&Expect::implementation_px_max, &Expect::truncation_px_max, &Expect::energy_drift_rel_max}) {
    expect = {};
    expect.*bound = 0.0;
    EXPECT_EQ(judged(hard_case, Invariant::expectations), CaseVerdict::broken);
  }
}

}  // namespace
}  // namespace hyrax

// Members by every kernel, against the replay of each: all numbers, bit for bit.
#include "sim/ensemble/ensemble.h"
#include "sim/core/shipped_core.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <tuple>

#include "sim/core/core.h"
#include "sim/core/listing_core.h"
#include "sim/ensemble/lanes.h"
#include "tests/unit/sim/replay/some_flings.h"

namespace hyrax {
namespace {

std::uint64_t seed_of_today() {
  if (const char* const given = std::getenv("HYRAX_SEED")) return std::strtoull(given, nullptr, 10);
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

KeepSet kept(std::initializer_list<Keep> all) {
  KeepSet keep;
  for (const Keep each : all) keep.add(each);
  return keep;
}
const KeepSet kAllButTheHash = kept({Keep::final, Keep::contacts, Keep::at_rest, Keep::extremes});
const KeepSet kFinalOnly = kept({Keep::final});
const KeepSet kWithoutExtremes = kept({Keep::final, Keep::contacts, Keep::at_rest});

Sweep sweep_over(Scenario base, std::int64_t members, KeepSet keep = kAllButTheHash) {
  Sweep sweep;
  sweep.base = std::move(base);
  sweep.members = members;
  sweep.seed = 5;
  sweep.keep = keep;
  sweep.vary = {{"/start/vx_px_per_s", ScenarioNumberKind::real, UniformDraw{-2500.0, 2500.0}},
                {"/start/vy_px_per_s", ScenarioNumberKind::real, UniformDraw{-1500.0, 500.0}},
                {"/start/x_px", ScenarioNumberKind::real, UniformDraw{-100.0, 2000.0}}};
  return sweep;
}

bool is_same(double a, double b) { return same_bits(a, b) || (std::isnan(a) && std::isnan(b)); }

// The first difference; empty if there is none.
std::string difference(const MemberResult& a, const MemberResult& b, const KeepSet& keep) {
  if (keep.has(Keep::final) && !same_bits(a.final, b.final)) return "final state";
  if (keep.has(Keep::contacts) && !(a.contacts == b.contacts)) return "contacts";
  if (keep.has(Keep::at_rest) && !is_same(a.at_rest_since_s, b.at_rest_since_s)) return "at_rest_since_s";
  if (!keep.has(Keep::extremes)) return "";
  const bool is_equal = is_same(a.x_min_px, b.x_min_px) && is_same(a.x_max_px, b.x_max_px) &&
                        is_same(a.y_min_px, b.y_min_px) && is_same(a.y_max_px, b.y_max_px);
  if (!is_equal) return "extremes";
  return is_same(a.speed_max_px_per_s, b.speed_max_px_per_s) ? "" : "speed_max";
}

// Of the replay's numbers, by which kernels may find them in different ways, those of each set.
void expect_same(Sweep sweep, const std::string& note, const std::vector<KeepSet>& keeps = {kAllButTheHash},
                 const Core& core = shipped_core()) {
  const auto members = static_cast<std::size_t>(sweep.members);
  Core step_by_step = core;
  step_by_step.paper_match = {};
  std::vector<MemberResult> expected(members);
  const StepTally replayed = EnsemblePlayer(step_by_step, sweep).play({}, 0, expected);
  for (std::size_t set = 0; set < keeps.size(); ++set)
    for (const KernelSet& kernels : kernel_sets()) {
      sweep.keep = keeps[set];
      std::vector<MemberResult> found(members);
      const StepTally tally = EnsemblePlayer(core, sweep, &kernels).play({}, 0, found);
      EXPECT_EQ(tally.steps, replayed.steps) << note;
      EXPECT_LE(tally.computed, tally.steps) << note;
      for (std::size_t member = 0; member < members; ++member) {
        const std::string differs = difference(found[member], expected[member], sweep.keep);
        EXPECT_EQ(differs, "") << kernels.name << ", set " << set << ", member " << member << " of " << note;
        if (!differs.empty()) break;
      }
    }
}

void expect_same_in_all_details(const Sweep& sweep, const std::string& note) {
  expect_same(sweep, note, {kAllButTheHash, kFinalOnly, kWithoutExtremes});
}

TEST(Ensemble, EqualsTheReplayAtEveryEndOfABlockAtEveryRateAndInLongRuns) {
  const auto expect_same_at = [](double rate_hz, std::int64_t steps, std::int64_t members) {
    expect_same_in_all_details(sweep_over(fling_at(rate_hz, steps), members),
                               std::to_string(steps) + " steps at " + std::to_string(rate_hz) + " Hz");
  };
  for (const std::int64_t steps : {0, 1, 2, 3, 47, 48, 49, 50, 95, 96, 97, 144, 145, 600, 601})
    expect_same_at(60.0, steps, 70);
  for (const double rate_hz : {24.0, 58.0, 60.0, 75.0, 89.0, 100.0, 144.0, 240.0, 1000.0})
    expect_same_at(rate_hz, 2000, 40);
  for (const std::int64_t steps : {4000, 5001, 70'001})
    for (const double rate_hz : {60.0, 120.0, 500.0}) expect_same_at(rate_hz, steps, 36);
}

// The last slides faster and faster, to the walls.
TEST(Ensemble, EqualsTheReplayWithConstantsOfItsOwn) {
  for (const Constants& constants : {Constants{980.0, 0.75, 0.9985, 0.65, 12.0},
                                     {1200.0, 0.6, 1.0, 1.0, 5.0},
                                     {1200.0, 0.6, 1.0, 1.02, 5.0},
                                     {-700.0, 0.6, 0.999, 0.8, 5.0},
                                     {1200.0, 1.3, 1.01, -0.8, 5.0},
                                     {0.0, -0.6, -0.999, 0.8, -5.0},
                                     {1e12, 0.0, 0.0, 1e12, 1e12}})
    expect_same(sweep_over(fling_at(60.0, 900), 40), std::to_string(constants.ground_friction),
                {kAllButTheHash, kFinalOnly}, listing_core(constants));
}

// Those of the base by the kernels, varied ones step by step.
TEST(Ensemble, PlaysParametersAsTheConstantsOfACoreThatHasThem) {
  Constants changed = shipped_core().constants.value();
  changed.gravity_px_per_s2 = 980.5;
  changed.restitution = 0.75;
  Sweep sweep = sweep_over(fling_at(60.0, 900), 40);
  std::vector<MemberResult> expected(40), found(40);
  const StepTally as_own = EnsemblePlayer(listing_core(changed), sweep).play({}, 0, expected);
  sweep.base.parameters = {{"GRAVITY", 980.5}, {"RESTITUTION", 0.75}};
  const StepTally tally = EnsemblePlayer(shipped_core(), sweep).play({}, 0, found);
  EXPECT_EQ(tally.computed, as_own.computed) << "by the same kernels";
  for (std::size_t member = 0; member < found.size(); ++member)
    EXPECT_EQ(difference(found[member], expected[member], sweep.keep), "") << member;

  sweep.vary.push_back({"/parameters/GRAVITY", ScenarioNumberKind::real, UniformDraw{500.0, 1500.0}});
  EnsemblePlayer(shipped_core(), sweep).play({}, 0, found);
  SweepMembers members(sweep);
  for (std::size_t member = 0; member < found.size(); ++member) {
    const Scenario& scenario = members.scenario(static_cast<std::int64_t>(member));
    EXPECT_NE(changed.gravity_px_per_s2, scenario.parameters[0].value);
    Constants own = changed;
    own.gravity_px_per_s2 = scenario.parameters[0].value;
    MemberResult alone;
    play_member(listing_core(own), scenario, sweep.keep, alone);
    EXPECT_EQ(difference(found[member], alone, sweep.keep), "") << member;
  }
}

TEST(Ensemble, EqualsTheReplayWhereMembersHaveDifferentLengthsAndRates) {
  Scenario base = fling_at(60.0, 0);
  base.length = 7.5;
  Sweep sweep = sweep_over(base, 200);
  sweep.vary.push_back({"/clock/rate_hz", ScenarioNumberKind::real, ChoiceDraw{{60.0, 120.0, 144.0}}});
  sweep.vary.push_back({"/duration_s", ScenarioNumberKind::real, UniformDraw{0.0, 30.0}});
  sweep.vary.push_back(
      {"/window/width_px", ScenarioNumberKind::integer, UniformDraw{std::int64_t{100}, std::int64_t{1920}}});
  sweep.vary.push_back(
      {"/sprite/height_px", ScenarioNumberKind::integer, UniformDraw{std::int64_t{1}, std::int64_t{1200}}});
  expect_same_in_all_details(sweep, "lengths, rates and sizes");
}

// Rounding keeps such a speed from becoming 0: in a long frame it moves the sprite by the least number there
// is.
TEST(Ensemble, EqualsTheReplayWhereASubnormalSpeedMoves) {
  constexpr double kLeast = 4.94065645841246544e-324;
  for (const double rate_hz : {0.5, 2.0, 60.0})
    for (const int width_px : {128, 1920}) {
      Scenario base = fling_at(rate_hz, 3000);
      base.window.width_px = width_px;
      base.start.y_px = base.window.height_px - base.sprite.height_px;
      base.start_velocity.vy_px_per_s = 0.0;
      Sweep sweep = sweep_over(base, 150);
      sweep.vary = {{"/start/vx_px_per_s", ScenarioNumberKind::real,
                     ChoiceDraw{{kLeast, -kLeast, 2.0 * kLeast, -2.0 * kLeast, -1e-320}}},
                    {"/start/x_px", ScenarioNumberKind::real,
                     ChoiceDraw{{0.0, kLeast, 20.0 * kLeast, 200.0 * kLeast, 1e-310, 1e-290, 9.0}}}};
      expect_same_in_all_details(sweep, "subnormal speeds at " + std::to_string(rate_hz) + " Hz");
    }
}

TEST(Ensemble, EqualsTheReplayWithEvents) {
  Scenario base = eventful_fling();
  base.clock.jitter.reset();
  expect_same_in_all_details(sweep_over(base, 70), "events");
  for (const KeepSet& less : {kFinalOnly, kWithoutExtremes})  // The replay, too, keeps less.
    expect_same(sweep_over(base, 70, less), "events", {less});
  // Held to the end; the place is where it rests.
  expect_same(
      sweep_over(fling_at(60.0, 200, {{std::int64_t{10}, Grab{}}, {std::int64_t{30}, Place{{9.0, 9.0}}}}), 3),
      "placed while held");
  Sweep sweep = sweep_over(base, 70);
  sweep.vary.push_back(
      {"/events/1/step", ScenarioNumberKind::integer, UniformDraw{std::int64_t{0}, std::int64_t{60}}});
  sweep.vary.push_back({"/events/2/hitch/dt_s", ScenarioNumberKind::real, UniformDraw{0.0, 1.0}});
  sweep.vary.push_back({"/events/4/place/x_px", ScenarioNumberKind::real, UniformDraw{-100.0, 3000.0}});
  sweep.vary.push_back({"/events/8/resize/window/width_px", ScenarioNumberKind::integer,
                        UniformDraw{std::int64_t{0}, std::int64_t{2000}}});
  expect_same_in_all_details(sweep, "events of different frames");
  sweep.members = 1030;
  sweep.base.events.back().when = 5.2;  // After the others, however long the hitch is.
  sweep.base.clock.jitter = eventful_fling().clock.jitter;
  sweep.vary.push_back({"/clock/jitter/seed", ScenarioNumberKind::seed, MemberNumber{}});
  expect_same(sweep, "events of different frames, more members than are played together");
}

TEST(Ensemble, EqualsTheReplayWithJitter) {
  for (const auto& [kind, pointer, most] : {std::tuple{Jitter::Kind::uniform, "/clock/jitter/fraction", 1.0},
                                            {Jitter::Kind::normal, "/clock/jitter/sigma_s", 0.05},
                                            {Jitter::Kind::missed_frames, "/clock/jitter/probability", 1.0}})
    for (Scenario base : {fling_at(60.0, 700), eventful_fling()}) {
      base.clock.jitter = Jitter{kind, most, 1};
      if (!base.events.empty()) base.events.back().when = std::int64_t{250};
      Sweep sweep = sweep_over(base, 40);
      sweep.vary.push_back({"/clock/jitter/seed", ScenarioNumberKind::seed, MemberNumber{}});
      expect_same_in_all_details(sweep, pointer);
      sweep.vary.push_back({"/clock/rate_hz", ScenarioNumberKind::real, UniformDraw{50.0, 150.0}});
      sweep.vary.push_back({pointer, ScenarioNumberKind::real, UniformDraw{0.0, most}});
      expect_same_in_all_details(sweep, std::string(pointer) + " and rates");
      base = fling_at(60.0, 50);
      base.clock = {FixedStep{0.9e9}, Jitter{kind, most, 0xFFFFFFFFFFFFFF11u}};  // To the longest frames.
      expect_same(sweep_over(base, 8), std::string(pointer) + " in long frames");
    }
}

TEST(Ensemble, EqualsTheReplayOfATrace) {
  Draws draws(3);
  RecordedSteps trace;
  for (int frame = 0; frame < 500; ++frame)
    trace.dt_s.push_back(frame % 7 == 0 ? 0.0 : frame % 3 == 0 ? 1.0 / 60.0 : draws.between(0.0, 0.04));
  Scenario base = eventful_fling();
  base.clock = {trace, {}};
  base.length = std::monostate{};
  expect_same_in_all_details(sweep_over(base, 40), "trace");
  Sweep sweep = sweep_over(base, 10);
  sweep.vary.push_back({"/clock/dt_s/3", ScenarioNumberKind::real, UniformDraw{0.0, 0.1}});
  expect_same(sweep, "a trace that varies");
}

// The anchor of rest moves four frames into the slide, 0.4 px below where it was; a hitch then lifts the
// sprite by little more than what moves the anchor again.
TEST(Ensemble, EqualsTheReplayWhereASlideIsFollowedByAHop) {
  Scenario base = fling_at(60.0, 1700, {{std::int64_t{1528}, Hitch{0.07805447451969494}}});
  base.window = {137, 979};
  base.sprite = {22, 5};
  base.clock.base = FixedStep{0.01437251433599018};
  base.start = {1035.1689219779505, 646.2350539075571};
  base.start_velocity.vy_px_per_s = -1303.3649095226378;
  Sweep sweep = sweep_over(base, 1);
  sweep.vary = {{"/start/vx_px_per_s", ScenarioNumberKind::real, ChoiceDraw{{50.364585217972945}}}};
  expect_same_in_all_details(sweep, "a hop after a slide");
}

TEST(Ensemble, EqualsTheReplayOfAnyFling) {
  const std::uint64_t seed = seed_of_today();
  for (std::uint64_t number = 0; number < 60; ++number) {
    const std::int64_t steps = number % 10 == 0 ? 9000 : 500;
    expect_same_in_all_details(sweep_over(any_fling(seed + number, steps), 40),
                               "HYRAX_SEED=" + std::to_string(seed) + ", number " + std::to_string(number));
  }
}

TEST(Ensemble, LeavesOutWhatRepeats) {
  std::vector<MemberResult> results(64);
  const Sweep sweep = sweep_over(fling_at(60.0, 100'000'000), 64, kFinalOnly);
  const StepTally tally = EnsemblePlayer(shipped_core(), sweep).play({}, 0, results);
  EXPECT_EQ(tally.steps, 64 * std::int64_t{100'000'000});
  EXPECT_LT(tally.computed, 64 * 20'000);
}

}  // namespace
}  // namespace hyrax

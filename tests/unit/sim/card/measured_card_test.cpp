// All that is measured of two cores, from a small library and few flings: the card is the one approved. Runs
// that are longer than what is kept of them are compared to their end.
#include <gtest/gtest.h>

#include "sim/card/card.h"
#include "sim/core/contact_kernel.h"
#include "sim/core/core_of.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/physics/physics.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

PlayWatch play_watch{};

ComparedCore base_core() {
  return compared_core(0, {.counted = shipped_core(), .timed = shipped_core(), .lacking = {}},
                       shipped_core().record, play_watch);
}

// Of other constants than it says.
ComparedCore candidate_with(void (*change)(Constants&)) {
  Constants constants = shipped_core().constants.value();
  change(constants);
  Core core = listing_core(constants);
  core.constants = shipped_core().constants;
  return compared_core(1, {.counted = core, .timed = core, .lacking = {}}, {.why_incomplete = "not traced"},
                       play_watch);
}

Constants& bouncy(Constants& constants) {
  constants.restitution = 0.9;
  return constants;
}

TEST(MeasuredCard, IsTheOneApproved) {
  const ComparedCore base = base_core();
  const ComparedCore candidate = candidate_with([](Constants& constants) {  // Bounces higher, slides farther.
    bouncy(constants).ground_friction = 0.95;
  });
  Scenario high = fling_at(60.0, 60);  // Bounces for half a minute by the candidate.
  high.window.height_px = 5000;
  std::int64_t now_ns = 0, calls = 0;
  CardRequest request{.library = {{"flings/calm.json", fling_at(60.0, 400)},
                                  {"recorded/eventful.json", eventful_fling()},
                                  {"hard/slow.json", fling_at(24.0, 100)},
                                  {"high.json", high}},
                      .seed = 3,
                      .flings = 6,
                      .now_ns = [&] { return now_ns += 100'000 + 400 * (++calls % 7); }};
  request.proof = {.is_complete = true, .is_equal = false, .why = "they differ"};
  request.rows_hash = {rows_hash(base, request), rows_hash(candidate, request)};
  const Card card = measure_card({base, candidate}, request);
  const Result result = card_result(card);
  std::string text = "at most " + six_digits(card.displays.distance_max_px) + " px apart on a display\n";
  const RestLine rest =
      measure_rest({base, candidate_with([](Constants& constants) { constants.restitution = 1.0; })});
  text += "a drop moves " + described(rest.moved_px.before) + "; springy " + described(rest.moved_px.after) +
          "\n";
  text += described(result.verdict);
  for (const Table& table : result.tables) text += described(table);
  for (const Figure& figure : result.figures) text += described(figure);
  expect_approved("tests/unit/sim/card/measured.txt", text);
}

// The core that is refused, and why.
std::string refused(const auto& work) {
  try {
    work();
  } catch (const CoreRefused& refusal) {
    return std::to_string(refusal.core) + ": " + refusal.what();
  }
  return "";
}

TEST(MeasuredCard, LeavesOutWhatIsNotMeasuredOrNoChange) {
  ComparedCore base = base_core();
  ComparedCore candidate =
      candidate_with([](Constants& constants) { bouncy(constants).ground_friction = 0.95; });
  Scenario still = fling_at(60.0, 50);  // In frames of no time it settles with neither core, nor moves in x.
  still.clock.base = FixedStep{0.0};
  still.start.y_px = 957.0;
  std::int64_t now_ns = 0;
  CardRequest request{
      .library = {{"recorded/still.json", still}, {"hard/long.json", fling_at(60.0, 2'000'000)}},
      .flings = 1,
      .now_ns = [&] { return now_ns += 100'000; },
      .proof = {.is_equal = true}};
  base.lacking = "GRAVITY";
  candidate.lacking = "AIR_DRAG";
  request.rows_hash = {rows_hash(base, request), rows_hash(candidate, request)};
  const Card other = measure_card({base, candidate}, request);
  EXPECT_EQ(other.step.status, StepStatus::not_proved);
  EXPECT_EQ(other.step.why, "the traced steps are equal, but the compiled cores give other bits");
  EXPECT_EQ(other.lacking, "the base has no GRAVITY; the candidate has no AIR_DRAG");
  EXPECT_EQ(other.claims.claims, 0);
  EXPECT_EQ(other.hard_cases.cases, 0) << "a long one";
  EXPECT_GT(other.hard_cases.other_random_runs.count, 0);
  EXPECT_EQ(other.hard_cases.listing.random_runs.after.count, 0);
  ASSERT_EQ(other.library.changed.size(), 2u);
  EXPECT_FALSE(other.library.changed[0].change.no_longer_settles);
  EXPECT_EQ(other.recordings, 1);
  EXPECT_TRUE(other.moved_recordings().empty());
  request.rows_hash.after = request.rows_hash.before;
  EXPECT_EQ(refused([&] {
              static_cast<void>(measure_card({base, candidate}, request));
            }),
            "1: does not repeat: scenarios played again by another process differ");
  candidate.lacking.clear();
  request.rows_hash.before = request.rows_hash.after = rows_hash(candidate, request);
  const Card same = measure_card({candidate, candidate}, request);
  EXPECT_EQ(same.step.status, StepStatus::proved_equal);
  EXPECT_GT(same.hard_cases.general.random_runs.before.count, 0);
  EXPECT_EQ(same.hard_cases.general.random_runs.after.count,
            same.hard_cases.general.random_runs.before.count);
  EXPECT_TRUE(same.hard_cases.general.newly_broken.empty());
}

// Plays the beginning of a second run otherwise.
struct Worn : physics {
  using physics::physics;
  void update(double dt_s, int width_px, int height_px, int sprite_width_px, int sprite_height_px) {
    static int calls = 0;
    physics::update(++calls > 100 ? 0.5 * dt_s : dt_s, width_px, height_px, sprite_width_px,
                    sprite_height_px);
  }
};

TEST(MeasuredFlings, AreRefusedOfACoreThatDoesNotRepeatThem) {
  const Core worn = core_of<Worn>(kPhysicsModel, {});
  const ComparedCore candidate = compared_core(1, {.counted = worn, .timed = worn, .lacking = {}},
                                               {.why_incomplete = "not traced"}, play_watch);
  Card card{.seed = 5, .flings = 2};
  EXPECT_EQ(refused([&] {
              measure_flings({base_core(), candidate}, card);
            }),
            "1: does not repeat: random fling 0 of seed 5 played twice differs");
}

TEST(MeasuredFlings, ThatDoNotStayFiniteAreLeftOutOfBothCores) {
  Card card{.seed = 1, .flings = 2};
  measure_flings({base_core(), candidate_with([](Constants& constants) { constants.air_drag = 1e200; })},
                 card);
  EXPECT_EQ(card.random.classes.of(DifferenceClass::shape), 2);
  EXPECT_EQ(card.random.settled.before, 2);
  EXPECT_EQ(card.random.settled.after, 0);
  EXPECT_EQ(card.random.no_longer_settle, 2);
  EXPECT_FALSE(card.random.shift_px);
  EXPECT_FALSE(card.energy_px2_per_s2[0].before);
  EXPECT_FALSE(card.exact_px.back().before);
}

// Each core is timed once, then the base and the candidate, the candidate and the base, and so on: 30,000
// steps in 1 and 3 ns each.
TEST(MeasuredCost, IsOfTheCandidateOverTheBaseWhicheverIsTimedFirst) {
  const ComparedCore core = base_core();
  std::int64_t now_ns = 0, calls = 0;
  const CostLine cost = measure_cost({core, core}, 1, [&] {
    const std::int64_t sample = calls / 2 % 4;
    if (calls++ % 2 == 1) now_ns += sample == 1 || sample == 2 ? 30'000 : 90'000;
    return now_ns;
  });
  EXPECT_EQ(cost.step_ns.before.median, 1.0);
  EXPECT_EQ(cost.step_ns.after.median, 3.0);
  EXPECT_EQ(cost.ratio.low, 3.0);
  EXPECT_EQ(cost.ratio.high, 3.0);
}

constexpr Constants kPaper{.gravity_px_per_s2 = 1200.0,
                           .restitution = 0.6,
                           .air_drag = 0.999,
                           .ground_friction = 0.8,
                           .rest_threshold_px_per_s = 5.0};

// Stands on the floor, where friction changes nothing, until it is flung.
Scenario flung_at(std::int64_t frame) {
  Scenario scenario = fling_at(60.0, kCoreRunRowsMax + 100'000, {{frame, Fling{{900.0, -500.0}}}});
  scenario.start_velocity = {};
  scenario.start = {300.0, bounds_of(scenario.window, scenario.sprite).bottom_px};
  return scenario;
}

Core core_with_friction(double ground_friction) {
  Constants constants = kPaper;
  constants.ground_friction = ground_friction;
  return listing_core(constants);
}

CoreRun run_with_friction(double ground_friction, const Scenario& scenario) {
  return play_by(core_with_friction(ground_friction), scenario);
}

bool settles_with_friction(double ground_friction, const Scenario& scenario) {
  const Core core = core_with_friction(ground_friction);
  return settles(core, scenario, play_by(core, scenario));
}

// With friction the fling settles after some seconds, without friction never.
TEST(CoreRun, ThatEndsBeforeItSettlesIsPlayedOn) {
  Scenario scenario = fling_at(60.0, 120);
  for (const bool is_recorded : {false, true}) {
    if (is_recorded) scenario.clock.base = RecordedSteps{std::vector(120, 1.0 / 60.0)};
    EXPECT_FALSE(run_with_friction(0.8, scenario).at_rest_since_s);
    EXPECT_TRUE(settles_with_friction(0.8, scenario)) << is_recorded;
    EXPECT_FALSE(settles_with_friction(1.0, scenario)) << is_recorded;
  }
  scenario.clock.base = FixedStep{0.0};
  EXPECT_FALSE(settles_with_friction(0.8, scenario));
}

TEST(CompareRuns, FindsADifferenceBeforeAndPastTheLastRowKept) {
  for (const bool is_cut : {false, true}) {
    const Scenario scenario = flung_at(kCoreRunRowsMax + (is_cut ? 50'000 : -50'000));
    const CoreRun run = run_with_friction(0.8, scenario);
    EXPECT_EQ(run.is_cut, is_cut);
    EXPECT_EQ(run.repetition.has_value(), !is_cut);
    EXPECT_EQ(std::ssize(run.rows) == kCoreRunRowsMax, is_cut);
    const auto changed_to = [&](CoreRun candidate) {
      CoreRun base = run;
      return compare_runs(scenario, base, candidate);
    };
    EXPECT_TRUE(changed_to(run).has_same_bits);
    const RunChange change = changed_to(run_with_friction(0.7, scenario));
    EXPECT_FALSE(change.has_same_bits) << is_cut;
    EXPECT_EQ(change.is_cut, is_cut);
    if (!is_cut) continue;
    const RunChange ended = changed_to(run_with_friction(1e300, scenario));
    EXPECT_TRUE(ended.became_non_finite);
    EXPECT_EQ(ended.difference, DifferenceClass::shape) << "though all rows that were kept are the same";
  }
}

TEST(CompareRuns, FindsNoStateThatBecameNonFiniteWhereThatOfTheBaseDidToo) {
  Constants unbounded = kPaper;
  unbounded.air_drag = 1e200;
  const Scenario scenario = fling_at(60.0, 5);
  const CoreRun run = play_by(listing_core(unbounded), scenario);
  for (CoreRun base : {run, run_with_friction(0.8, scenario)}) {
    CoreRun candidate = run;
    EXPECT_EQ(compare_runs(scenario, base, candidate).became_non_finite, base.is_finite);
  }
}

// Told by its rows alone, what stands at the left wall touches it in every step.
TEST(CompareRuns, FindsNoOtherBitsWhereContactsAloneAreOthers) {
  Scenario scenario = flung_at(kCoreRunRowsMax + 50'000);
  scenario.start.x_px = 0.0;
  Core by_rows = listing_core(kPaper);
  by_rows.kernel = std::make_shared<const ContactKernel>(by_rows.kernel, nullptr, std::nullopt);
  CoreRun base = play_by(listing_core(kPaper), scenario);
  CoreRun candidate = play_by(by_rows, scenario);
  const RunChange change = compare_runs(scenario, base, candidate);
  EXPECT_NE(change.contacts_before, change.contacts_after);
  EXPECT_TRUE(base.is_cut);
  EXPECT_TRUE(change.has_same_bits);
}

}  // namespace
}  // namespace hyrax

// Which frame an event falls on: the published vectors, faults, and a plain walk over every frame.
#include "sim/scenario/schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "sim/scenario/frame_clock.h"
#include "sim/search/draws.h"
#include "tests/oracle/vectors.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Event at_step(std::int64_t step, Action action = Stop{}) { return {step, std::move(action)}; }
Event at_time(double at_s, Action action = Stop{}) { return {at_s, std::move(action)}; }

Scenario with_events(Clock clock, std::int64_t steps, std::vector<Event> events) {
  Scenario scenario;
  scenario.clock = std::move(clock);
  scenario.length = steps;
  scenario.events = std::move(events);
  return scenario;
}

Schedule schedule(const Scenario& scenario) { return schedule_events(scenario, step_count(scenario)); }

Schedule at_one_hz(std::int64_t steps, std::vector<Event> events) {
  return schedule(with_events({FixedStep{1.0}, {}}, steps, std::move(events)));
}

// The published frame, -1 for one beyond the end.
std::int64_t published_frame(const Json& entry) {
  return entry.find("frame")->is_null() ? -1 : integer_of(entry, "frame");
}

Scenario scenario_of(const Json& entry) {
  const Event timed = at_time(exact(entry, "at_s"));
  const std::string& clock = text_of(entry, "clock");
  if (clock == "fixed")
    return with_events({FixedStep{exact(entry, "dt_s")}, {}}, integer_of(entry, "steps"), {timed});
  const std::vector<double> dts_s = exact_list(entry, "dts_s");
  const auto steps = static_cast<std::int64_t>(dts_s.size());
  if (clock == "array") return with_events({RecordedSteps{dts_s}, {}}, steps, {timed});
  // A fixed clock whose odd frames are hitches; those before the event come before it in the list.
  std::vector<Event> events;
  const std::int64_t frame = published_frame(entry);
  for (std::int64_t at = 0; at < steps; ++at) {
    const double dt_s = dts_s[static_cast<std::size_t>(at)];
    if (dt_s != exact(entry, "dt_s") && (frame < 0 || at < frame)) events.push_back(at_step(at, Hitch{dt_s}));
  }
  events.push_back(timed);
  return with_events({FixedStep{exact(entry, "dt_s")}, {}}, steps, events);
}

TEST(Schedule, ResolvesTimesToThePublishedFrames) {
  for (const Json& entry : vectors("at_s")) {
    const Schedule result = schedule(scenario_of(entry));
    EXPECT_EQ(result.frames.back(), published_frame(entry))
        << text_of(entry, "clock") << ", at_s " << text_of(entry, "at_s");
    EXPECT_EQ(result.faulty.empty(), published_frame(entry) >= 0);
  }
}

// Even where the limit of walked frames would let it walk them all.
TEST(Schedule, DrawsNoJitterAfterTheLastTimedEvent) {
  const Clock clock{FixedRate{60.0}, Jitter{Jitter::Kind::uniform, 0.5, 1}};
  const Scenario scenario =
      with_events(clock, kStepsMax, {at_time(0.5), at_step(kStepsMax - 2), at_step(kStepsMax - 1)});
  EXPECT_EQ(schedule_events(scenario, kStepsMax, kStepsMax).frames.back(), kStepsMax - 1);
}

// Start times far from zero are far apart: many short frames start at the same rounded time.
TEST(Schedule, PicksTheFirstOfManyFramesThatStartAtTheSameTime) {
  const double after_a_gap_s = std::nextafter(1e9, kInfinity);
  const Scenario scenario =
      with_events({FixedStep{1e-9}, {}}, 1000, {at_step(0, Hitch{1e9}), at_time(after_a_gap_s)});
  // 1e9 + n * 1e-9 rounds up to the next double from half a gap on: 2^-24 s is 59.6 frames.
  EXPECT_EQ(schedule(scenario).frames, (std::vector<std::int64_t>{0, 61}));
}

TEST(Schedule, EndsWhereNoFrameMovesTime) {
  const Scenario scenario = with_events({FixedStep{1e-300}, {}}, kStepsMax,
                                        {at_step(0, Hitch{1e9}), at_time(std::nextafter(1e9, kInfinity))});
  ASSERT_EQ(schedule(scenario).faulty.size(), 1u);
  EXPECT_EQ(schedule(scenario).faulty[0].fault, ScheduleFault::beyond_end);
}

Clock jittered(Jitter::Kind kind, double amount) { return {FixedStep{1.0}, Jitter{kind, amount, 1}}; }

std::optional<ScheduleFault> fault_of_last(const Schedule& result) {
  if (result.faulty.empty() || result.faulty.back().event + 1 != result.frames.size()) return std::nullopt;
  return result.faulty.back().fault;
}

constexpr std::int64_t kWalkedMax = 100;

Schedule walked_to_100(const Scenario& scenario) {
  return schedule_events(scenario, step_count(scenario), kWalkedMax);
}

TEST(Schedule, WalksJitteredFramesUpToItsLimit) {
  const Clock clock = jittered(Jitter::Kind::missed_frames, 0.0);
  EXPECT_EQ(walked_to_100(with_events(clock, kStepsMax, {at_time(100.0)})).frames,
            (std::vector<std::int64_t>{100}));
  EXPECT_EQ(walked_to_100(with_events(clock, kStepsMax, {at_step(100), at_time(100.0)})).frames,
            (std::vector<std::int64_t>{100, 100}));
  EXPECT_EQ(fault_of_last(walked_to_100(with_events(clock, kStepsMax, {at_time(101.0)}))),
            ScheduleFault::too_far);
  EXPECT_EQ(fault_of_last(walked_to_100(with_events(clock, 100, {at_time(100.0)}))),
            ScheduleFault::beyond_end);
}

// Every frame as long as jitter can make it, of a dt that is longer than the float next to it.
TEST(Schedule, FindsATimeThatOnlyTheLongestFramesReach) {
  const double longest_s = 1.0 + 0.99 * 0x1p-24;
  const Clock clock{FixedStep{0.5 * longest_s}, Jitter{Jitter::Kind::missed_frames, 1.0, 1}};
  const Scenario scenario = with_events(clock, kStepsMax, {at_time((1e6 - 0.01) * longest_s)});
  EXPECT_EQ(schedule_events(scenario, kStepsMax, 1'000'000).frames, (std::vector<std::int64_t>{1'000'000}));
}

TEST(Schedule, LeavesAFixedClockWithoutThatLimit) {
  const Scenario scenario =
      with_events({FixedStep{1.0}, {}}, kStepsMax, {at_step(1, Hitch{0.5}), at_time(5e11)});
  EXPECT_EQ(schedule(scenario).frames.back(), 500'000'000'001);
}

// Walking every frame of one of these would take hours at least.
TEST(Schedule, RefusesQuicklyWhatIsTooFarForEveryKindOfJitter) {
  for (const auto& [kind, amount] : {std::pair{Jitter::Kind::uniform, 1.0},
                                     {Jitter::Kind::normal, 10.0},
                                     {Jitter::Kind::missed_frames, 0.5}}) {
    const std::vector<Event> events(10'000, at_time(1e11));
    const Schedule result = schedule(with_events(jittered(kind, amount), kStepsMax, events));
    ASSERT_EQ(result.faulty.size(), events.size());
    EXPECT_EQ(fault_of_last(result), ScheduleFault::too_far);
    EXPECT_EQ(fault_of_last(schedule(with_events(jittered(kind, amount), kStepsMax, {at_time(1e300)}))),
              ScheduleFault::beyond_end);
  }
}

// The time of that step is unknown, so the end's is as well.
TEST(Schedule, RefusesATimeAfterAStepThatIsTooFar) {
  for (const std::int64_t step : {kStepsMax / 2, kStepsMax / 10 * 9}) {
    const Clock clock = jittered(Jitter::Kind::uniform, 0.5);
    const Schedule result =
        schedule(with_events(clock, kStepsMax, {at_step(step), at_time(9.5e11), at_step(kStepsMax - 1)}));
    EXPECT_EQ(result.frames, (std::vector<std::int64_t>{step, -1, kStepsMax - 1}));
    ASSERT_EQ(result.faulty.size(), 1u);
    EXPECT_EQ(result.faulty.front().fault, ScheduleFault::too_far);
  }
}

// Between the mean and the longest time only a walk finds the frame, and a hitch invalidates its result.
TEST(Schedule, WalksToTheEndOnceForManyLateEvents) {
  RecordedSteps trace;
  trace.dt_s.assign(101, 1.0);
  for (const Clock& clock : {jittered(Jitter::Kind::missed_frames, 0.0), Clock{trace, {}}}) {
    const Scenario once = with_events(
        clock, 101, {at_step(0, Hitch{1.0}), at_time(150.0), at_step(0, Hitch{1.0}), at_time(150.0)});
    EXPECT_EQ(walked_to_100(once).frames, (std::vector<std::int64_t>{0, -1, 0, -1}));
    EXPECT_EQ(walked_to_100(once).faulty.size(), 1u);
  }
  // One frame short of the limit, once more.
  const Scenario twice = with_events(jittered(Jitter::Kind::missed_frames, 0.0), kStepsMax,
                                     {at_step(1), at_time(150.0), at_time(150.0), at_time(150.0)});
  EXPECT_EQ(walked_to_100(twice).frames, (std::vector<std::int64_t>{1, -1, -1, -1}));
  EXPECT_EQ(walked_to_100(twice).faulty.size(), 2u);
}

// A time beyond the end gives the latest time of the last frame, to the last bit.
TEST(Schedule, FindsTheLatestTimeOfTheLastFrameAfterOneBeyondTheEnd) {
  double latest_s = 4.0;
  while (4.0 >= std::nextafter(latest_s, kInfinity) - 1e-9) latest_s = std::nextafter(latest_s, kInfinity);
  EXPECT_EQ(at_one_hz(5, {at_time(9.0), at_time(latest_s)}).frames, (std::vector<std::int64_t>{-1, 4}));
  EXPECT_EQ(at_one_hz(5, {at_time(9.0), at_time(std::nextafter(latest_s, kInfinity))}).frames.back(), -1);
}

// The rule implemented literally: for every event, every frame from the first one.
Schedule walk_plainly(const Scenario& scenario, std::int64_t steps) {
  const FrameClock clock(scenario.clock);
  std::vector<double> dts_s;
  for (std::int64_t frame = 0; frame < steps; ++frame) dts_s.push_back(clock.dt_s(frame));
  Schedule result;
  std::int64_t frame_before = 0;
  for (const Event& event : scenario.events) {
    std::int64_t frame = 0;
    if (const auto* step = std::get_if<std::int64_t>(&event.when)) frame = *step;
    Timeline timeline;
    if (const auto* at_s = std::get_if<double>(&event.when))
      for (; frame < steps && !(timeline.time_s() >= *at_s - 1e-9 * clock.nominal_dt_s(frame)); ++frame)
        timeline.play(dts_s[static_cast<std::size_t>(frame)]);
    const bool is_faulty = frame >= steps || frame < frame_before;
    result.frames.push_back(is_faulty ? -1 : frame);
    if (is_faulty) {
      result.faulty.push_back({result.frames.size() - 1,
                               frame >= steps ? ScheduleFault::beyond_end : ScheduleFault::goes_backwards});
      continue;
    }
    frame_before = frame;
    if (const auto* hitch = std::get_if<Hitch>(&event.action))
      dts_s[static_cast<std::size_t>(frame)] = hitch->dt_s;
  }
  return result;
}

template <class Value>
Value one_of(Draws& draws, std::initializer_list<Value> values) {
  return values.begin()[draws.below(values.size())];
}

Clock any_clock(Draws& draws, std::int64_t steps) {
  const double dt_s = one_of(draws, {1.0, 0.1, 1.0 / 60.0, 1e-9, 0.0, 3e-7});
  switch (draws.below(5)) {
    case 0:
      return {FixedStep{dt_s}, {}};
    case 1:
      return {FixedStep{dt_s}, Jitter{Jitter::Kind::uniform, draws.between(0.0, 1.0), draws.below(99)}};
    case 2:
      return {FixedStep{dt_s}, Jitter{Jitter::Kind::normal, draws.between(0.0, 1.0) * dt_s, draws.below(99)}};
    case 3:
      return {FixedStep{dt_s}, Jitter{Jitter::Kind::missed_frames, draws.between(0.0, 1.0), draws.below(99)}};
    default:
      RecordedSteps trace;
      for (std::int64_t frame = 0; frame < steps; ++frame)
        trace.dt_s.push_back(one_of(draws, {dt_s, 0.1, 0.0, 1e-3, 1.0}));
      return {trace, {}};
  }
}

// Events roughly in order, some beyond the end or before the last one, timed ones within some ulps of the end
// of the allowance.
std::vector<Event> any_events(Draws& draws, const Clock& clock, std::int64_t steps) {
  const FrameClock frames(clock);
  Timeline timeline;
  std::vector<Event> events;
  for (std::int64_t frame = 0; frame < steps; ++frame) {
    const double allowance_s = 1e-9 * frames.nominal_dt_s(frame);
    double at_s = timeline.time_s() + one_of(draws, {0.0, 0.0, allowance_s, -allowance_s, 9.0});
    for (std::uint64_t ulps = draws.below(4); ulps > 0; --ulps) at_s = std::nextafter(at_s, kInfinity);
    const Action action =
        draws.below(3) == 0 ? Action(Hitch{one_of(draws, {0.0, 0.1, 1e9, 0.3})}) : Action(Stop{});
    const std::int64_t step = std::max<std::int64_t>(0, frame + one_of(draws, {0, 0, 0, -1, 20}));
    if (draws.below(4) == 0)
      events.push_back(draws.below(2) == 0 ? at_step(step, action) : at_time(at_s, action));
    const auto* hitch = std::get_if<Hitch>(&action);
    const bool is_hitched = hitch != nullptr && !events.empty() && events.back().action == action;
    timeline.play(is_hitched ? hitch->dt_s : frames.dt_s(frame));
  }
  return events;
}

TEST(Schedule, AgreesWithAPlainWalkForEveryClock) {
  int faulty = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    Draws draws(seed);
    const auto steps = static_cast<std::int64_t>(draws.below(41));
    const Clock clock = any_clock(draws, steps);
    const Scenario scenario = with_events(clock, steps, any_events(draws, clock, steps));
    const Schedule expected = walk_plainly(scenario, steps);
    const Schedule result = schedule_events(scenario, steps);
    for (std::size_t event = 0; event < expected.frames.size(); ++event)
      ASSERT_EQ(result.frames[event], expected.frames[event]) << "seed " << seed << ", event " << event;
    ASSERT_EQ(result.faulty.size(), expected.faulty.size()) << "seed " << seed;
    for (std::size_t fault = 0; fault < expected.faulty.size(); ++fault)
      ASSERT_EQ(result.faulty[fault].fault, expected.faulty[fault].fault) << "seed " << seed;
    faulty += expected.faulty.empty() ? 0 : 1;
  }
  EXPECT_GT(faulty, 100);
  EXPECT_EQ(at_one_hz(0, {at_step(0), at_time(0.0)}).frames, (std::vector<std::int64_t>{-1, -1}));
}

TEST(Inputs, EndWithTheRun) {
  const Scenario scenario =
      with_events({FixedRate{60.0}, {}}, 10, {at_step(0), at_step(3, Grab{}), at_step(4, Release{})});
  EXPECT_EQ(inputs_of(scenario, 4), (std::vector<Input>{{0, Stop{}}, {3, Grab{}}}));
  EXPECT_EQ(inputs_of(scenario, 5).size(), 3u);
}

TEST(Inputs, AreTwoForAResizeOfWindowAndSprite) {
  const Scenario scenario =
      with_events({FixedRate{60.0}, {}}, 10, {at_step(5, Resize{Size{800, 600}, Size{64, 32}})});
  EXPECT_EQ(inputs_of(scenario, 10),
            (std::vector<Input>{{5, Resize{Size{800, 600}, {}}}, {5, Resize{{}, Size{64, 32}}}}));
}

TEST(Inputs, AreTheSameInTheirBitsOnly) {
  const Input fling{1, Fling{{0.0, 2.0}}};
  EXPECT_TRUE(same_bits(fling, fling));
  EXPECT_EQ(fling, (Input{1, Fling{{-0.0, 2.0}}}));
  EXPECT_FALSE(same_bits(fling, Input{1, Fling{{-0.0, 2.0}}}));
  EXPECT_FALSE(same_bits(fling, Input{2, Fling{{0.0, 2.0}}}));
  EXPECT_FALSE(same_bits(fling, Input{1, Release{{0.0, 2.0}}}));
  EXPECT_FALSE(same_bits(Input{1, Place{{0.0, 1.0}}}, Input{1, Place{{0.0, -1.0}}}));
  EXPECT_FALSE(same_bits(Input{1, Hitch{0.0}}, Input{1, Hitch{-0.0}}));
  EXPECT_FALSE(same_bits(Input{1, Resize{Size{1, 1}, {}}}, Input{1, Resize{{}, Size{1, 1}}}));
}

}  // namespace
}  // namespace hyrax

// Methods of a work-precision diagram (SpeedErrorRules hold their orders), and costs by a clock that the test
// controls.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/compare/comparison.h"
#include "sim/core/core_of.h"
#include "sim/core/shipped_core.h"
#include "sim/study/methods/cost.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/speed_error/speed_error.h"
#include "tests/unit/sim/study/swept_physics.h"

namespace hyrax {
namespace {

// A clock that works set forward; what does not, as the probe, takes 50 us by it.
struct Clock {
  std::int64_t now_ns = 0;

  Stopwatch stopwatch() {
    return [this](const std::function<void()>& work) {
      const std::int64_t from_ns = now_ns;
      work();
      return now_ns == from_ns ? std::int64_t{50'000} : now_ns - from_ns;
    };
  }
};

TEST(TimeWorks, MeasuresEachWorkSeparately) {
  Clock clock;
  std::int64_t runs = 0;
  const auto slow_at_times = [&] { clock.now_ns += ++runs % 5 == 0 ? 70'000 : 50'000; };
  const Works works = {[&] { clock.now_ns += 100; }, [&] { clock.now_ns += 7'000; },
                       [&] { clock.now_ns += 50'000; }, slow_at_times};
  const ProcessTimes times = time_works(works, clock.stopwatch(), {.rounds = 40}, 0);
  EXPECT_EQ(times.works_ns, (std::vector{100.0, 7'000.0, 50'000.0, 50'000.0})) << "few slow runs are ignored";
}

TEST(TimeWorks, EveryRoundHasEveryWorkOnceInAMixedOrder) {
  Clock clock;
  std::vector<std::size_t> order;
  Works works;
  for (std::size_t work = 0; work < 4; ++work)
    works.push_back([&, work] {
      clock.now_ns += 100'000;
      order.push_back(work);
    });
  std::vector<std::vector<std::size_t>> orders;
  for (int process = 0; process < 2; ++process) {
    order.clear();
    static_cast<void>(time_works(works, clock.stopwatch(), {.rounds = 25}, process));
    ASSERT_EQ(order.size(), 8u + 4u * 25u);  // Warming up, and how long a run takes.
    orders.push_back(order);
  }
  EXPECT_NE(orders[0], orders[1]) << "each process has orders of its own";
  int in_turn = 0;
  for (std::size_t first = 8; first < order.size(); first += 4) {
    const auto round = order.begin() + static_cast<std::ptrdiff_t>(first);
    EXPECT_EQ(std::set(round, round + 4).size(), 4u);
    for (std::size_t at = first; at < first + 4; ++at) in_turn += order[at] == (order[at - 1] + 1) % 4;
  }
  EXPECT_LT(in_turn, 50);
}

// One run of the probe takes 50 us by this clock, and so do any number: their mean says how many there were.
TEST(TimeWorks, ProbesTheClockForAsLongAsEachSampleTook) {
  Clock clock;
  const Works works = {[&] { clock.now_ns += 5'000'000; }};
  EXPECT_EQ(time_works(works, clock.stopwatch(), {.rounds = 1}, 0).probe.median_ns, 500.0);
}

// Of 40 works, one of which takes 10 us more in the samples whose probes take a quarter longer, and more.
TEST(TimeWorks, ASampleWhoseProbeDriftsIsLeftOut) {
  struct Case {
    int rounds, drifting;
    std::int64_t probe_ns;
    double work_ns;
  };
  for (const Case& of : {Case{4, 2, 63'000, 50'000.0},
                         {4, 3, 63'000, kNotGiven},
                         {5, 3, 63'000, kNotGiven},
                         {4, 3, 62'000, 60'000.0}}) {
    std::int64_t now_ns = 0;
    std::size_t last = 0;
    int samples = -2;  // Of the last work, after two runs to warm up.
    Works works;
    for (std::size_t work = 0; work < 40; ++work)
      works.push_back([&, work] {
        last = work;
        if (work == 7) ++samples;
        now_ns += work == 7 && samples > 0 && samples <= of.drifting ? 60'000 : 50'000;
      });
    const Stopwatch time_of = [&](const std::function<void()>& work) -> std::int64_t {
      const std::int64_t from_ns = now_ns;
      work();
      if (now_ns != from_ns) return now_ns - from_ns;
      return last == 7 && samples <= of.drifting ? of.probe_ns : 50'000;
    };
    const ProcessTimes times = time_works(works, time_of, {.rounds = of.rounds}, 0);
    EXPECT_TRUE(times.probe.is_steady());
    EXPECT_EQ(times.works_ns[6], 50'000.0);
    if (std::isnan(of.work_ns))
      EXPECT_TRUE(std::isnan(times.works_ns[7])) << "less than half of its samples is left";
    else
      EXPECT_EQ(times.works_ns[7], of.work_ns) << of.drifting << " of " << of.probe_ns;
  }
}

TEST(CostsOf, HaveAValueOfEachProcess) {
  const Costs measured =
      costs_of({{{5.0, 1.0}, {10.0, 0.1}}, {{7.0, kNotGiven}, {10.0, 0.2}}, {{6.0, 1.0}, {}}});
  EXPECT_EQ(measured.costs[0].processes_ns, (std::vector{5.0, 7.0, 6.0}));
  EXPECT_EQ(measured.costs[0].time_ns.median, 6.0);
  EXPECT_EQ(measured.costs[0].time_ns.high, 7.0);
  EXPECT_FALSE(measured.costs[1].is_measured()) << "not by every process";
  EXPECT_TRUE(std::isnan(measured.costs[1].time_ns.median));
  EXPECT_EQ(measured.probe.drift_rel, 0.2);
}

TEST(CostsOf, AnUnsteadyClockMeasuresNothing) {
  Clock clock;
  const Works works(20, [&] { clock.now_ns += 50'000; });
  const auto measured = [&](std::int64_t times_longer) {
    const Stopwatch drifting = [&, time_of = clock.stopwatch(),
                                readings = std::int64_t{0}](const std::function<void()>& work) mutable {
      return time_of(work) * (1 + times_longer * (++readings % 3));
    };
    return costs_of({time_works(works, drifting, {}, 0)});
  };
  EXPECT_TRUE(measured(0).costs[0].is_measured());
  EXPECT_EQ(measured(0).probe.drift_rel, 0.0);
  EXPECT_FALSE(measured(1).probe.is_steady());
  EXPECT_FALSE(measured(1).costs[0].is_measured());
  EXPECT_EQ(unsteady_text({.median_ns = 1.0, .drift_rel = 0.4}),
            "not measured: clock unsteady (drift 40 %, at most 25 %)");
  EXPECT_EQ(unsteady_text({.median_ns = 1.0, .drift_rel = 0.25}), "not measured: clock unsteady");
}

TEST(IsCheaper, InEveryProcess) {
  const Cost steady = cost_of({10, 10, 10, 10, 10, 10});
  const Cost cheaper = cost_of({9, 9.5, 9, 9.5, 9, 9.9});
  EXPECT_TRUE(is_cheaper(cheaper, steady));
  EXPECT_FALSE(is_cheaper(steady, cheaper));
  EXPECT_FALSE(is_cheaper(cost_of({9, 9, 9, 9, 9, 11}), steady)) << "reversed in one process";
  EXPECT_FALSE(is_cheaper(cost_of({9, 9, 9, 9, 9, 10}), steady)) << "equal in one process";
  EXPECT_FALSE(is_cheaper(cost_of({9, 9, 9, 9, 9}), cost_of({10, 10, 10, 10, 10}))) << "too few processes";
  EXPECT_FALSE(is_cheaper(cheaper, steady, 2)) << "too few for two comparisons";
  EXPECT_FALSE(is_cheaper(Cost(), steady));
  EXPECT_FALSE(is_cheaper(steady, Cost()));
}

// A machine that slows down from process to process changes neither a rank nor a part that is taken off.
TEST(IsCheaper, ComparesProcessByProcess) {
  const Cost a = cost_of({10, 20, 30, 40, 50, 60, 70, 80, 90});
  const Cost b = cost_of({11, 21, 31, 41, 51, 61, 71, 81, 91});
  EXPECT_TRUE(is_cheaper(a, b));
  const Cost difference = difference_of(b, a, 2.0);
  EXPECT_EQ(difference.time_ns.low, 0.5);
  EXPECT_EQ(difference.time_ns.high, 0.5);
}

// 2^(1 - n) times the comparisons is at most 5 %.
TEST(ProcessesFor, AreMoreTheMoreComparisonsThereAre) {
  for (const auto& [comparisons, processes] :
       {std::pair(0, 6), {1, 6}, {2, 7}, {3, 7}, {4, 8}, {6, 8}, {7, 9}, {46'812, 21}})
    EXPECT_EQ(processes_for(comparisons), processes) << comparisons;
}

MethodKind kind_of(const std::string& name) {
  for (const MethodKind& kind : frame_methods(shipped_core()))
    if (kind.name == name) return kind;
  ADD_FAILURE() << "no method " << name;
  return {};
}

Problem problem_named(const std::string& name) {
  for (const Problem& problem : study_problems(FixedLaws()))
    if (problem.name == name) return problem;
  ADD_FAILURE() << "no problem " << name;
  return {};
}

MethodErrors errors_of(const std::string& method, const Problem& problem, double rate_hz) {
  return measure_errors(shipped_core(), problem, kind_of(method), stage_frames_s(problem, rate_hz), rate_hz);
}

// Methods that find impacts frame by frame converge to the exact impacts.
TEST(FrameMethods, AllThatSolveTheFixedLawsTendToTheSameFling) {
  for (const char* name : {"fling", "corner-fling", "jittered-fling"}) {
    const Problem fling = problem_named(name);
    for (const char* method : {"normalised-drag", "verlet", "rk4", "exact-flight"}) {
      const MethodErrors coarse = errors_of(method, fling, 120.0);
      const MethodErrors fine = errors_of(method, fling, 7680.0);
      EXPECT_LT(fine.position_px, coarse.position_px / 8.0) << method << ", " << name;
      // Each of three impacts is found up to a frame late, which jitter makes half as long again.
      EXPECT_LT(fine.contact_time_s, 3.0 * 1.5 / 7680.0) << method << ", " << name;
    }
    EXPECT_GT(errors_of("paper", fling, 7680.0).position_px, 100.0) << name;
  }
}

TEST(FrameMethods, ImpactsInsideTheFrameKeepAFastSpriteInsideASmallWindow) {
  Problem problem = problem_named("fling");
  problem.start = {1.0, 2.0, 1e6, -1e6};
  problem.stages = {{.duration_s = 5.0, .bounds = {3.0, 0.0}}};
  const MethodErrors errors = errors_of("exact-impacts", problem, 15.0);
  EXPECT_FALSE(errors.is_failed);
  EXPECT_LT(errors.position_px, 1e-6);
}

// With its own program and its own series: the code that sim/physics/README.md shows.
TEST(FrameMethods, TheSweptClampIsTheOneThatIsShown) {
  const Core shown = core_of<SweptPhysics>("swept", {});
  for (const Problem& fling : problems_like(problem_named("fling"), 20)) {
    const std::vector<double> frames_s = stage_frames_s(fling, 60.0).front();
    const Bounds room = fling.stages.front().bounds;
    const auto method = kind_of("swept-clamp").make();
    method->start(fling.start, room, false);
    for (std::size_t frame = 0; frame < frames_s.size(); frame += 24) {
      ASSERT_TRUE(method->play(std::span(frames_s).subspan(frame, 24)));
      const State end = shown.played(fling.start, std::span(frames_s).first(frame + 24), room);
      EXPECT_NEAR(distance_px(method->motion(), end), 0.0, 1e-6) << frame;
    }
  }
}

TEST(FrameMethods, ASweptClampIsOfSecondOrderAtWalls) {
  for (const char* name : {"fling", "corner-fling", "jittered-fling"}) {
    const Problem fling = problem_named(name);
    const double at_60_hz_px = errors_of("swept-clamp", fling, 60.0).position_px;
    EXPECT_LT(at_60_hz_px, errors_of("exact-flight", fling, 60.0).position_px / 10.0) << name;
    EXPECT_LT(errors_of("swept-clamp", fling, 960.0).position_px, at_60_hz_px / 100.0) << name;
  }
}

// What changes nothing, a hitch of one frame's length and the window's own size, cuts the slide into stages.
TEST(FrameMethods, ASlideGoesOnPastWhatLeavesItOnTheGround) {
  Problem slide = problem_named("fling"), cut = slide;
  const Bounds room = slide.stages[0].bounds;
  slide.start = cut.start = {100.0, room.bottom_px, 3000.0, 0.0};
  slide.stages = {{.duration_s = 1.0, .bounds = room}};
  cut.stages = {{.duration_s = 0.25, .bounds = room},
                {.duration_s = 0.25, .bounds = room, .hitch_s = 1.0 / 64.0},
                {.duration_s = 0.5, .bounds = room, .inputs = {Resize{.window = Size{1920, 1080}}}}};
  for (const MethodKind& kind : frame_methods(shipped_core())) {
    const MethodErrors whole = errors_of(kind.name, slide, 64.0), parts = errors_of(kind.name, cut, 64.0);
    EXPECT_NEAR(parts.position_px, whole.position_px, 1e-9) << kind.name;
    EXPECT_NEAR(parts.end_px, whole.end_px, 1e-9) << kind.name;
  }
}

// Whatever a method remembers of a sprite that flies, slides or has long been still.
TEST(FrameMethods, AfterInputsAMethodPlaysAsFromAFreshStart) {
  Problem fresh = problem_named("fling"), later = fresh;
  const Bounds room = fresh.stages[0].bounds;
  fresh.stages = {{.duration_s = 3.0, .bounds = room}};
  const State in_air = fresh.start, on_ground = {300.0, room.bottom_px, 900.0, 0.0};
  // Laid on the ground out of its flight; one that lies there already slides on without an impact.
  for (const auto& [from, all_before_s] :
       {std::pair(in_air, std::vector{0.5, 6.0, 40.0}), {on_ground, {0.5}}}) {
    fresh.start = from;
    for (const double before_s : all_before_s) {
      later.stages = {{.duration_s = before_s, .bounds = room}, fresh.stages[0]};
      later.stages[1].inputs = {Place{{from.x_px, from.y_px}}, Fling{{from.vx_px_per_s, from.vy_px_per_s}}};
      for (const MethodKind& kind : frame_methods(shipped_core())) {
        const auto alone = kind.make(), after = kind.make();
        ASSERT_TRUE(play_through(fresh, *alone, stage_frames_s(fresh, 64.0)));
        ASSERT_TRUE(play_through(later, *after, stage_frames_s(later, 64.0)));
        EXPECT_NEAR(distance_px(alone->motion(), after->motion()), 0.0, 1e-9) << kind.name << before_s;
      }
    }
  }
}

TEST(FrameMethods, FramesOfNoLengthChangeNothing) {
  const Bounds room = problem_named("fling").stages[0].bounds;
  const std::vector<double> frames_s(40, 1.0 / 64.0);
  std::vector<double> with_others_s;
  for (const double frame_s : frames_s) with_others_s.insert(with_others_s.end(), {frame_s, 0.0});
  for (const MethodKind& kind : frame_methods(shipped_core())) {
    if (std::holds_alternative<Divergent>(kind.accuracy)) continue;  // Its drag is taken once a frame.
    State ends[2];
    for (const bool has_others : {false, true}) {
      const auto method = kind.make();
      method->start({100.0, room.bottom_px, 3000.0, 0.0}, room, false);
      ASSERT_TRUE(method->play(has_others ? with_others_s : frames_s));
      ends[has_others] = method->motion();
    }
    EXPECT_NEAR(distance_px(ends[0], ends[1]), 0.0, 1e-9) << kind.name;
  }
}

TEST(FrameMethods, AMethodThatLeavesTheNumbersHasFailed) {
  class Lost final : public Method {
   public:
    void start(const State&, const Bounds&, bool) override {}
    bool play(std::span<const double>) override { return true; }
    [[nodiscard]] State motion() const override { return {std::nan(""), 0.0, 0.0, 0.0}; }
  };
  MethodKind kind{.name = "lost", .make = [] { return std::make_unique<Lost>(); }};
  const Problem arc = problem_named("long-arc");
  EXPECT_TRUE(measure_errors(shipped_core(), arc, kind, stage_frames_s(arc, 60.0), 60.0).is_failed);
}

}  // namespace
}  // namespace hyrax

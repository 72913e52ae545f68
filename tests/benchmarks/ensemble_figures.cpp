// Many members at once, against naive stepping of each.
#include <fmt/format.h>

#include <random>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/ensemble/ensemble.h"
#include "sim/ensemble/lanes.h"
#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {
namespace {

constexpr std::int64_t kSteps = 600;
constexpr std::int64_t kMembers = 2048;
constexpr int kRounds = 15;

constexpr std::initializer_list<Keep> kLeast{Keep::final};
constexpr std::initializer_list<Keep> kUsual{Keep::final, Keep::contacts, Keep::at_rest};

// Throws all over a desktop.
Sweep throws(std::int64_t steps, std::initializer_list<Keep> keep) {
  Sweep sweep;
  sweep.base = desktop_fling({}, steps);
  sweep.members = kMembers;
  sweep.seed = 2026;
  sweep.vary = {{"/start/vx_px_per_s", ScenarioNumberKind::real, UniformDraw{-2000.0, 2000.0}},
                {"/start/vy_px_per_s", ScenarioNumberKind::real, UniformDraw{-2000.0, 2000.0}},
                {"/start/x_px", ScenarioNumberKind::real, UniformDraw{0.0, 1792.0}},
                {"/start/y_px", ScenarioNumberKind::real, UniformDraw{0.0, 952.0}}};
  for (const Keep each : keep) sweep.keep.add(each);
  return sweep;
}

Sweep jittered_throws(std::int64_t steps, std::initializer_list<Keep> keep) {
  Sweep sweep = throws(steps, keep);
  sweep.base.clock.jitter = Jitter{Jitter::Kind::uniform, 0.2, 0};
  sweep.vary.insert(sweep.vary.begin(), {"/clock/jitter/seed", ScenarioNumberKind::seed, MemberNumber{}});
  return sweep;
}

std::vector<State> starts_of(const Sweep& sweep) {
  SweepMembers members(sweep);
  std::vector<State> starts;
  for (std::int64_t member = 0; member < sweep.members; ++member)
    starts.push_back(start_state(members.scenario(member)));
  return starts;
}

// As people write it, with the standard library's generator.
void step_naively_with_jitter(const std::vector<State>& starts) {
  std::uint64_t seed = 0;
  for (const State& start : starts) {
    std::mt19937_64 generator(seed++);
    std::uniform_real_distribution<double> draw(0.8 * kDt_s, 1.2 * kDt_s);
    physics body = body_at(start);
    for (std::int64_t step = 0; step < kSteps; ++step) naive_step(body, draw(generator), kDesktop);
    keep(body);
  }
}

// Every step computed: the kernel alone.
void step_in_lanes(const KernelSet& kernels, const std::vector<State>& starts) {
  Lanes lanes{};
  lanes.right_px.fill(1792.0);
  lanes.bottom_px.fill(952.0);
  lanes.dt_s.fill(kDt_s);
  for (std::size_t first = 0; first + kLanes <= starts.size(); first += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const State& start = starts[first + lane];
      lanes.x_px[lane] = start.x_px;
      lanes.y_px[lane] = start.y_px;
      lanes.vx_px_per_s[lane] = start.vx_px_per_s;
      lanes.vy_px_per_s[lane] = start.vy_px_per_s;
    }
    kernels.play(lanes, kSteps, Detail::final, LaneClock::fixed);
    keep(lanes);
  }
}

// Plays a sweep again and again, as a thread of the command does chunk after chunk.
class SweepPlayer {
 public:
  explicit SweepPlayer(const Sweep& sweep)
      : player_(shipped_core(), sweep), results_(static_cast<std::size_t>(sweep.members)) {}
  void play() { keep(player_.play({}, 0, results_)); }

 private:
  EnsemblePlayer player_;
  std::vector<MemberResult> results_;
};

double goal_of(const std::string& name) {
  if (name == "AVX-512") return 16.0;
  if (name == "AVX2") return 10.0;
  return name == "SSE4" ? 4.5 : 1.0;
}

void add_kernel_figures(std::vector<Figure>& figures) {
  const std::vector<State> starts = starts_of(throws(kSteps, kLeast));
  std::vector<std::function<void()>> works{[&] { step_all_naively(starts, kSteps); }};
  for (const KernelSet& kernels : kernel_sets()) works.emplace_back([&] { step_in_lanes(kernels, starts); });
  const auto timings = time_side_by_side(works, kRounds);
  for (std::size_t set = 0; set < kernel_sets().size(); ++set) {
    const std::string name = kernel_sets()[set].name;
    figures.push_back(ratio("10 s at 60 Hz, every step, " + name + ", times faster than naive", timings[0],
                            timings[set + 1], Goal::at_least, goal_of(name)));
  }
}

// Of what is kept the ends alone, and as by default.
void add_sweep_figures(std::vector<Figure>& figures, const std::string& what, const Sweep& least,
                       const Sweep& usual, const std::function<void(const std::vector<State>&)>& step_all,
                       double goal) {
  const std::vector<State> starts = starts_of(least);
  SweepPlayer least_player(least);
  SweepPlayer usual_player(usual);
  const auto timings = time_side_by_side(
      {[&] { step_all(starts); }, [&] { least_player.play(); }, [&] { usual_player.play(); }}, kRounds);
  figures.push_back(ratio(what, timings[0], timings[1], Goal::at_least, goal));
  figures.push_back(ratio("(the same with the default keep)", timings[0], timings[2], Goal::at_least, 1.0));
}

// Naive stepping that packs and hashes every row.
void add_hash_figure(std::vector<Figure>& figures) {
  const Sweep sweep = throws(kSteps, {Keep::state_hash});
  SweepPlayer player(sweep);
  const std::vector<State> starts = starts_of(sweep);
  const auto naive = [&] {
    for (const State& start : starts) {
      physics body = body_at(start);
      StateHash hash;
      hash.add(Row{0, 0.0, 0.0, body.x(), body.y(), body.vx(), body.vy(), 0});
      for (std::int64_t step = 1; step <= kSteps; ++step) {
        naive_step(body, kDt_s, kDesktop);
        hash.add(Row{step, 0.0, kDt_s, body.x(), body.y(), body.vx(), body.vy(), 0});
      }
      keep(hash.value());
    }
  };
  const auto timings = time_side_by_side({naive, [&] { player.play(); }}, kRounds);
  figures.push_back(ratio("sweep with state_hash, times faster than naive with the same hash", timings[0],
                          timings[1], Goal::at_least, 2.0));
}

}  // namespace

std::vector<Figure> ensemble_figures() {
  std::vector<Figure> figures;
  add_kernel_figures(figures);
  for (const auto& [steps, goal] : {std::pair(kSteps, 25.0), std::pair(10 * kSteps, 150.0)})
    add_sweep_figures(
        figures, fmt::format("sweep of {} s at 60 Hz, times faster than naive", steps / 60),
        throws(steps, kLeast), throws(steps, kUsual),
        [steps = steps](const auto& starts) { step_all_naively(starts, steps); }, goal);
  add_sweep_figures(figures, "sweep of jitter seeds, times faster than naive with mt19937_64",
                    jittered_throws(kSteps, kLeast), jittered_throws(kSteps, kUsual),
                    step_naively_with_jitter, 10.0);
  add_hash_figure(figures);
  return figures;
}

}  // namespace hyrax::bench

#include "sim/study/methods/many_flings.h"

#include <cmath>

#include "sim/core/core.h"
#include "sim/scenario/frame_clock.h"

namespace hyrax {
namespace {

// All flings with one jitter seed: every kJitterSeeds-th.
Sweep with_jitter_seed(Sweep sweep, std::int64_t part) {
  if (sweep.base.clock.jitter) sweep.base.clock.jitter->seed = kJitterSeed + static_cast<std::uint64_t>(part);
  return sweep;
}

}  // namespace

ManyFlings::ManyFlings(const Clock& clock, double duration_s, std::int64_t flings) {
  Scenario& base = sweep_.base;
  base.sprite = {128, 128};
  base.window = {static_cast<std::int32_t>(kDesktop.right_px) + base.sprite.width_px,
                 static_cast<std::int32_t>(kDesktop.bottom_px) + base.sprite.height_px};
  base.clock = clock;
  base.length = std::llround(std::ceil(duration_s / base_dt_s(clock)));
  sweep_.members = flings;
  sweep_.seed = kFlingSeed;
  for (const Keep each : {Keep::final, Keep::contacts, Keep::at_rest}) sweep_.keep.add(each);
  sweep_.vary = {{"/start/vx_px_per_s", ScenarioNumberKind::real, UniformDraw{-2000.0, 2000.0}},
                 {"/start/vy_px_per_s", ScenarioNumberKind::real, UniformDraw{-2000.0, 500.0}},
                 {"/start/x_px", ScenarioNumberKind::real, UniformDraw{0.0, kDesktop.right_px}},
                 {"/start/y_px", ScenarioNumberKind::real, UniformDraw{0.0, kDesktop.bottom_px}}};
}

State ManyFlings::start(std::int64_t fling) const {
  SweepMembers members(sweep_);
  return start_state(members.scenario(fling));
}

Clock ManyFlings::clock(std::int64_t fling) const {
  return with_jitter_seed(sweep_, fling % kJitterSeeds).base.clock;
}

std::vector<MemberResult> ManyFlings::play(const Core& core) const {
  std::vector<MemberResult> results(static_cast<std::size_t>(sweep_.members));
  for (std::int64_t seed = 0; seed < std::min(sweep_.members, kJitterSeeds); ++seed) {
    const WorkPart part{seed, kJitterSeeds};
    const Sweep sweep = with_jitter_seed(sweep_, seed);
    std::vector<MemberResult> of_seed(static_cast<std::size_t>(part.rows(sweep_.members)));
    EnsemblePlayer(core, sweep).play(part, 0, of_seed);
    for (std::size_t row = 0; row < of_seed.size(); ++row)
      results[static_cast<std::size_t>(part.member(static_cast<std::int64_t>(row)))] = of_seed[row];
  }
  return results;
}

}  // namespace hyrax

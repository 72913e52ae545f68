#include "sim/core/shipped_core.h"
#include "sim/described/described_run.h"
#include "sim/described/see.h"
#include "sim/replay/replay.h"
#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {
namespace {

/// The shipped core as one that describes itself.
struct DescribedPhysics {
  physics body;

  void step(double dt_s) { body.update(dt_s, kDesktop.width_px, kDesktop.height_px, kSprite_px, kSprite_px); }
  void state(auto&& see) {
    see(
        "x_px", [&] { return body.x(); }, [&](double x_px) { body.setPos(x_px, body.y()); });
    see(
        "y_px", [&] { return body.y(); }, [&](double y_px) { body.setPos(body.x(), y_px); });
    see(
        "vx_px_per_s", [&] { return body.vx(); }, [&](double speed) { body.setVelocity(speed, body.vy()); });
    see(
        "vy_px_per_s", [&] { return body.vy(); }, [&](double speed) { body.setVelocity(body.vx(), speed); });
  }
};

}  // namespace

// The sprite is thrown again every ten seconds, so that it keeps flying and bouncing.
std::vector<Figure> described_figures() {
  constexpr std::int64_t kThrows = 1000, kFrames = 600;
  Scenario scenario = desktop_fling({}, kFrames * kThrows);
  DescribedScenario described;
  described.clock = scenario.clock;
  described.length = kFrames * kThrows;
  for (std::int64_t index = 0; index < kThrows; ++index) {
    const State start = random_throw(static_cast<std::size_t>(index));
    scenario.events.push_back({kFrames * index, Place{{start.x_px, start.y_px}}});
    scenario.events.push_back({kFrames * index, Fling{velocity_of(start)}});
    std::vector<GivenValue> given;
    for (const double value : {start.x_px, start.y_px, start.vx_px_per_s, start.vy_px_per_s})
      given.emplace_back(given.size(), word_of(value));
    described.events.push_back({kFrames * index, SetValues{{}, given}});
  }
  const DescribedCore core = described_core_of<DescribedPhysics>("described", {});
  const auto timings =
      time_side_by_side({[&] { keep(replay(shipped_core(), scenario, {}, {.skips_repetition = false})); },
                         [&] { keep(play(core, described, {})); }},
                        15);
  return {ratio("a described core of four doubles, part of the speed by PHYSICS", timings[0], timings[1],
                Goal::at_least, 80.0, 100.0)};
}

}  // namespace hyrax::bench

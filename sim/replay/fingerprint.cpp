#include "sim/replay/fingerprint.h"

#include <array>
#include <cmath>
#include <span>

#include "sim/replay/replay.h"
#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kEdgeRuns = 80;
constexpr std::size_t kEdgeFrames = 7;

// Each draw is a statement of its own: compilers differ in the order in which they evaluate arguments.
// Nothing here may depend on libm or give a NaN, whose bits differ between processors.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}

  double unit() { return split_mix64_unit(seed_, next_++); }
  template <class List>
  auto one_of(const List& list) {
    return list[static_cast<std::size_t>(unit() * static_cast<double>(std::size(list)))];
  }
  /// Up to 20 px/s, where the rest rule decides, or of any size up to 1e6 px/s; 0 now and then.
  double speed_px_per_s() {
    constexpr std::array kSigns = {-1.0, 1.0, -1.0, 1.0, 0.0};
    const double sign = one_of(kSigns);
    const double fraction = unit();
    const double choice = unit();
    if (choice < 0.4) return sign * 20.0 * fraction;
    return sign * std::ldexp(1.0 + fraction, static_cast<int>(40.0 * choice) - 20);
  }
  /// On a bound, within a hair of one, between both or far outside.
  double coordinate_px(double bound_px) {
    constexpr double kHair_px = 0x1p-20;
    const double fraction = unit();
    const std::array places = {0.0,
                               -kHair_px,
                               bound_px,
                               bound_px + kHair_px,
                               bound_px - kHair_px,
                               fraction * bound_px,
                               fraction * bound_px,
                               -1e6 * fraction};
    return one_of(places);
  }
  Velocity velocity() {
    const double vx_px_per_s = speed_px_per_s();
    return {vx_px_per_s, speed_px_per_s()};
  }
  Position position(const Size& window, const Size& sprite) {
    const double x_px = coordinate_px(window.width_px - sprite.width_px);
    return {x_px, coordinate_px(window.height_px - sprite.height_px)};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

Scenario edge_run(std::uint64_t seed) {
  constexpr std::array<Size, 4> kWindows = {{{1920, 1080}, {801, 600}, {100, 2160}, {0, 0}}};
  constexpr std::array kFrames_s = {1.0 / 60.0, 1.0 / 60.0, 1.0 / 144.0, 1.0 / 24.0, 0.25, 0.0};
  Draws draws(seed);
  Scenario run;
  run.window = draws.one_of(kWindows);
  run.sprite = {128, 96};
  run.start = draws.position(run.window, run.sprite);
  run.start_velocity = draws.velocity();
  RecordedSteps frames;
  for (std::size_t frame = 0; frame < kEdgeFrames; ++frame) frames.dt_s.push_back(draws.one_of(kFrames_s));
  run.clock.base = std::move(frames);
  run.events = {{std::int64_t{2}, Fling{draws.velocity()}},
                {std::int64_t{4}, Place{draws.position(run.window, run.sprite)}},
                {std::int64_t{6}, Stop{}}};
  return run;
}

}  // namespace

Digest fingerprint_of(const Core& core) {
  ByteHash hash;
  const auto add = [&](const Scenario& scenario) {
    const Digest played = replay(core, scenario).state_hash;
    hash.add(std::as_bytes(std::span(played)));
  };
  for (std::uint64_t seed = 0; seed < kEdgeRuns; ++seed) add(edge_run(seed));
  constexpr Size kWindow{1920, 1080};
  constexpr Size kSprite{128, 128};
  add(scenario_from({300.0, 500.0, 1700.0, -900.0}, kWindow, kSprite, 240.0, 1600));  // Until it has settled.
  // It bounces at 5 px/s, the threshold itself.
  add(scenario_from({896.0, 952.0, 9.0, -11.658324991658324}, kWindow, kSprite, 60.0, 2));
  return hash.value();
}

}  // namespace hyrax

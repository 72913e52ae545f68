#include "sim/search/random_scenario.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/motion/displays.h"
#include "sim/scenario/frame_clock.h"
#include "sim/search/draws.h"

namespace hyrax {
namespace {

constexpr double kPowersOfTen[] = {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
// Of flings: as displays have them.
constexpr double kFlingRates_hz[] = {24.0, 25.0,  30.0,  48.0,  50.0,  60.0,  72.0,  75.0,
                                     90.0, 100.0, 120.0, 144.0, 165.0, 200.0, 240.0, 360.0};
constexpr std::int64_t kFling_s = 10;
constexpr double kLongFrames_s[] = {0.1, 0.25, 1.0, 10.0, 1e3, 1e6, 1e9};

// Draws the parts of one scenario. Of any two numbers the draws are statements of their own, so that their
// order is the same with every compiler.
class Maker {
 public:
  Maker(std::uint64_t seed, const std::optional<Constants>& constants)
      : draws_(seed), constants_(constants), features_(draws_.bits()) {}

  [[nodiscard]] std::bitset<kFeatureCount> features() const { return features_; }

  Scenario scenario() {
    Scenario scenario = any_sizes();
    steps_ = any_length();
    scenario.clock = any_clock();
    if (!std::holds_alternative<RecordedSteps>(scenario.clock.base)) scenario.length = steps_;
    start(scenario);
    scenario.events = any_events();
    return scenario;
  }

  Scenario fling() {
    Scenario scenario = any_sizes();
    const double rate_hz = draws_.one_of(kFlingRates_hz);
    scenario.clock.base = FixedRate{rate_hz};
    if (has(Feature::jitter)) scenario.clock.jitter = any_jitter(1.0 / rate_hz);
    scenario.length = kFling_s * static_cast<std::int64_t>(rate_hz);
    start(scenario);
    return scenario;
  }

  std::vector<std::int64_t> stops() {
    std::vector<std::int64_t> stops{any_frame(), any_frame()};
    std::sort(stops.begin(), stops.end());
    return stops;
  }

 private:
  [[nodiscard]] bool has(Feature feature) const { return features_[static_cast<std::size_t>(feature)]; }

  Scenario any_sizes() {
    Scenario scenario;
    scenario.window = window_ = any_window();
    scenario.sprite = sprite_ = any_sprite();
    return scenario;
  }
  void start(Scenario& scenario) {
    scenario.start = has(Feature::rest) ? on_the_ground() : any_position();
    const double first_dt_s = FrameClock(scenario.clock).dt_s(0);
    scenario.start_velocity = has(Feature::rest) ? any_small_velocity(first_dt_s) : any_velocity();
    if (has(Feature::corners)) start_at_a_corner(scenario);
  }

  // Half of all numbers are whole: sums that round seldom hide what sums that round often show.
  double number(double low, double high) {
    const bool is_whole = draws_.once_in(2);
    const double value = draws_.between(low, high);
    return is_whole ? std::floor(value) : value;
  }
  std::int32_t side(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(draws_.below(static_cast<std::uint64_t>(high - low) + 1));
  }

  Size any_window() {
    if (!has(Feature::small_window) && draws_.once_in(2)) return draws_.one_of(kDisplays);
    const std::int32_t longest_px = has(Feature::small_window) ? 64 : 4000;
    const std::int32_t shortest_px = has(Feature::oversized) ? 0 : 1;
    const std::int32_t width_px = side(shortest_px, longest_px);
    return {width_px, side(shortest_px, longest_px)};
  }
  std::int32_t any_sprite_side(std::int32_t window_px) {
    const bool is_oversized = has(Feature::oversized) && draws_.once_in(2);
    if (is_oversized) return side(1, 2 * window_px + 64);
    return side(1, std::max(1, std::min(window_px, draws_.once_in(4) ? window_px : 128)));
  }
  Size any_sprite() {
    const std::int32_t width_px = any_sprite_side(window_.width_px);
    return {width_px, any_sprite_side(window_.height_px)};
  }

  double any_coordinate(double bound_px) {
    if (has(Feature::on_bounds) && draws_.once_in(4)) return draws_.once_in(2) ? 0.0 : bound_px;
    if (has(Feature::outside) && draws_.once_in(4)) {
      const double far_px = draws_.one_of(kPowersOfTen);
      return number(-far_px, far_px);
    }
    return number(0.0, std::max(bound_px, 0.0));
  }
  Position any_position() {
    const Bounds bounds = bounds_of(window_, sprite_);
    const double x_px = any_coordinate(bounds.right_px);
    return {x_px, any_coordinate(bounds.bottom_px)};
  }
  Position on_the_ground() {
    const Bounds bounds = bounds_of(window_, sprite_);
    return {any_coordinate(bounds.right_px), bounds.bottom_px};
  }

  double any_speed() {
    if (draws_.once_in(8)) return 0.0;
    const double fastest = has(Feature::fast) && draws_.once_in(4) ? draws_.one_of(kPowersOfTen) : 2500.0;
    return number(-fastest, fastest);
  }
  Velocity any_velocity() {
    const double vx_px_per_s = any_speed();
    return {vx_px_per_s, any_speed()};
  }
  Velocity any_small_velocity(double dt_s) {
    const double vx_px_per_s = draws_.once_in(2) ? 0.0 : number(-50.0, 50.0);
    if (draws_.once_in(4)) return {vx_px_per_s, threshold_speed(dt_s)};
    return {vx_px_per_s, draws_.once_in(2) ? 0.0 : number(-20.0, 20.0)};
  }
  // From which a frame that ends on the ground leaves the rest rule's threshold, often to the bit.
  [[nodiscard]] double threshold_speed(double dt_s) const {
    if (!constants_) return 0.0;
    return constants_->rest_threshold_px_per_s / constants_->restitution / constants_->air_drag -
           constants_->gravity_px_per_s2 * dt_s;
  }
  void start_at_a_corner(Scenario& scenario) {
    const Bounds bounds = bounds_of(window_, sprite_);
    const bool is_right = draws_.once_in(2);
    const bool is_bottom = draws_.once_in(2);
    const double x_px = number(0.0, 20.0);
    const double y_px = number(0.0, 20.0);
    scenario.start = {is_right ? bounds.right_px - x_px : x_px, is_bottom ? bounds.bottom_px - y_px : y_px};
    Velocity& velocity = scenario.start_velocity;
    velocity.vx_px_per_s = std::copysign(velocity.vx_px_per_s, is_right ? 1.0 : -1.0);
    velocity.vy_px_per_s = std::copysign(velocity.vy_px_per_s, is_bottom ? 1.0 : -1.0);
  }

  std::int64_t any_length() {
    const std::uint64_t longest = has(Feature::long_run) && draws_.once_in(8) ? 2000 : 80;
    return static_cast<std::int64_t>(1 + draws_.below(longest));
  }

  double any_dt_s() {
    if (!has(Feature::any_rate)) return 1.0 / draws_.one_of(kDisplayRates_hz);
    return draws_.between(0.0, draws_.once_in(4) ? 0.5 : 0.05);
  }
  double any_hitch_s() {
    if (has(Feature::zero_frames) && draws_.once_in(2)) return 0.0;
    const double longest_s = draws_.one_of(kLongFrames_s);
    return draws_.between(0.0, longest_s);
  }
  Clock any_clock() {
    if (has(Feature::recorded)) return {.base = any_trace(), .jitter = {}};
    Clock clock;
    if (has(Feature::zero_frames) && draws_.once_in(8))
      clock.base = FixedStep{0.0};
    else if (has(Feature::any_rate))
      clock.base = FixedStep{any_dt_s()};
    else
      clock.base = FixedRate{draws_.one_of(kDisplayRates_hz)};
    if (has(Feature::jitter)) clock.jitter = any_jitter(base_dt_s(clock));
    return clock;
  }
  RecordedSteps any_trace() {
    const double usual_s = any_dt_s();
    const bool is_even = draws_.once_in(4);
    RecordedSteps trace;
    trace.dt_s.reserve(static_cast<std::size_t>(steps_));
    for (std::int64_t frame = 0; frame < steps_; ++frame)
      trace.dt_s.push_back(any_recorded_s(usual_s, is_even));
    return trace;
  }
  double any_recorded_s(double usual_s, bool is_even) {
    if (has(Feature::zero_frames) && draws_.once_in(8)) return 0.0;
    if (has(Feature::hitches) && draws_.once_in(16)) return any_hitch_s();
    return is_even ? usual_s : usual_s * draws_.between(0.5, 1.5);
  }
  Jitter any_jitter(double dt_s) {
    Jitter jitter{.kind = static_cast<Jitter::Kind>(draws_.below(3))};
    jitter.amount = draws_.between(0.0, jitter.kind == Jitter::Kind::normal ? dt_s : 1.0);
    jitter.seed = draws_.bits();
    return jitter;
  }

  std::int64_t any_frame() {
    return static_cast<std::int64_t>(draws_.below(static_cast<std::uint64_t>(steps_)));
  }

  std::vector<Event> any_events() {
    std::vector<Feature> kinds;
    for (const Feature kind : {Feature::throws, Feature::holds, Feature::resizes, Feature::hitches})
      if (has(kind)) kinds.push_back(kind);
    if (kinds.empty()) return {};
    std::vector<std::int64_t> frames(draws_.below(7));
    for (std::int64_t& frame : frames) frame = any_frame();
    std::sort(frames.begin(), frames.end());
    std::vector<Event> events;
    events.reserve(frames.size());
    for (const std::int64_t frame : frames)
      events.push_back({frame, any_action(kinds[draws_.below(kinds.size())])});
    return events;
  }
  Action any_action(Feature kind) {
    switch (kind) {
      case Feature::holds:
        return any_of_a_hold();
      case Feature::resizes:
        return any_resize();
      case Feature::hitches:
        return Hitch{any_hitch_s()};
      default:
        return any_throw();
    }
  }
  Action any_throw() {
    if (draws_.once_in(4)) return Place{any_position()};
    if (draws_.once_in(4)) return Stop{};
    return Fling{any_velocity()};
  }
  Action any_of_a_hold() {
    if (is_held_ && draws_.once_in(2)) return Place{any_position()};
    is_held_ = !is_held_;
    if (is_held_) return Grab{};
    return Release{any_velocity()};
  }
  Action any_resize() {
    const std::uint64_t what = draws_.below(3);
    Resize resize;
    if (what != 0) resize.window = window_ = any_window();
    const bool fits = sprite_.width_px <= window_.width_px && sprite_.height_px <= window_.height_px;
    if (what != 1 || !(fits || has(Feature::oversized))) resize.sprite = sprite_ = any_sprite();
    return resize;
  }

  Draws draws_;
  std::optional<Constants> constants_;
  std::bitset<kFeatureCount> features_;
  std::int64_t steps_ = 0;
  Size window_;  // In force after the events so far.
  Size sprite_;
  bool is_held_ = false;
};

}  // namespace

Scenario random_fling(const Core& core, std::uint64_t seed, std::uint64_t number) {
  Scenario scenario = Maker(split_mix64(seed, number), core.constants).fling();
  scenario.name = "fling-" + std::to_string(seed) + "-" + std::to_string(number);
  return scenario;
}

RandomRun random_run(const Core& core, std::uint64_t seed, std::uint64_t run) {
  Maker maker(split_mix64(seed, run), core.constants);
  RandomRun random{.scenario = maker.scenario(), .stops = maker.stops(), .features = maker.features()};
  random.scenario.name = "fuzz-" + std::to_string(seed) + "-" + std::to_string(run);
  return random;
}

}  // namespace hyrax

// Families of hard cases: clocks, jitter, and length.
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_family.h"

namespace hyrax {
namespace {

constexpr char kNoZeroSpeed[] =
    "the position stands still at every rate, only vy differs: here a two-cycle or residual speed, not zero "
    "speed";

// Falling from rest takes t1 = sqrt(2 H / G); all bounces then 2 t1 b / (1 - b), with drag less. Where the
// frames drag so often that it sinks instead of falling, H / terminal speed comes on top.
struct DropTimes {
  double fall_s;
  double sink_s;
  double bounces;  // By how much all bounces lengthen a fall, as a factor.
};
DropTimes drop_times(const Core& core, const Scenario& drop, double rate_hz) {
  const Constants constants = core.constants.value();
  const double height_px = drop.window.height_px - drop.sprite.height_px - drop.start.y_px;
  return {
      std::sqrt(2.0 * height_px / constants.gravity_px_per_s2),
      height_px * (1.0 - constants.air_drag) / (constants.air_drag * constants.gravity_px_per_s2 / rate_hz),
      1.0 + 2.0 * constants.restitution / (1.0 - constants.restitution)};
}

double zero_speed_hz(const Core& core) {
  const Constants constants = core.constants.value();
  return constants.restitution * constants.air_drag * constants.gravity_px_per_s2 /
         constants.rest_threshold_px_per_s;
}

// The last moment of hitch_family.
constexpr std::int64_t kHitchAtRest = 500;
constexpr double kRestFastest_hz = 1e3, kZenoFastest_hz = 1e4;  // Of the families.

// On the floor each step of gravity adds a = drag * G * h to vy, and the bounce keeps restitution * a of it.
// The rest rule sets vy to 0 in every step if that is below its threshold; at other rates a two-cycle or
// residual speed is left. The position stands still at every rate.
bool ends_at_zero_speed(const Core& core, double rate_hz) { return rate_hz > zero_speed_hz(core); }

// By when it has settled, and is known to have, up to that rate.
double time_to_rest_s(const Core& core, const Scenario& drop, double rate_max_hz) {
  const DropTimes times = drop_times(core, drop, rate_max_hz);
  return times.fall_s * times.bounces + times.sink_s + 1.5;
}

// The first frame before kHitchAtRest in which the sprite lands, without its events.
std::optional<std::int64_t> first_landing(const Core& core, const Scenario& scenario) {
  const Bounds bounds = bounds_of(scenario.window, scenario.sprite);
  State body = start_state(scenario);
  for (std::int64_t frame = 0; frame < kHitchAtRest - 1; ++frame) {
    body = core.step(body, base_dt_s(scenario.clock), bounds);
    if (body.y_px == bounds.bottom_px) return frame;
  }
  return std::nullopt;
}

bool is_drop(const ScenarioForm& form) {
  return form.is_left_alone && form.has_room && form.is_inside && form.is_still &&
         form.start.y_px < form.bounds.bottom_px && std::holds_alternative<double>(form.scenario.length);
}

}  // namespace

void any_frame_family(const Core&, const ScenarioForm& form, Family& family) {
  const auto* const step = std::get_if<FixedStep>(&form.scenario.clock.base);
  if (step == nullptr || !(step->dt_s >= 0.1) || form.scenario.clock.jitter || !form.scenario.events.empty())
    return;
  for (const double dt_s : {0.0, 4.9406564584124654e-324, 1e-310, 1e-9, 1e-6, 1e-3, 0.02, 0.25, 0.5, 10.0,
                            1e3, 1e6, kFrameMax_s}) {
    Scenario scenario = form.scenario;
    scenario.clock.base = FixedStep{dt_s};
    family.add(fmt::format("dt-{:g}", dt_s), "a frame far from the sixtieth of a second that it was made for",
               scenario);
  }
}

// A hitch of half a second at each kind of moment, and of the hours for which a machine is suspended.
void hitch_family(const Core& core, const ScenarioForm& form, Family& family) {
  if (!(form.is_steady && form.length > kHitchAtRest && !form.scenario.events.empty() &&
        has_only<Hitch>(form.scenario.events)))
    return;
  const std::optional<std::int64_t> landing = first_landing(core, form.scenario);
  if (!landing) return;
  for (const auto& [moment, frame] : {std::pair("in-flight", *landing * 2 / 5),
                                      {"before-contact", *landing - 1},
                                      {"at-contact", *landing},
                                      {"after-contact", *landing + 1},
                                      {"at-rest", kHitchAtRest}})
    for (const double dt_s : {0.5, 3600.0, 28800.0}) {
      Scenario scenario = form.scenario;
      scenario.events = {{frame, Hitch{dt_s}}};
      family.add(fmt::format("{}-{:g}-s", moment, dt_s),
                 "one frame takes long: nothing may be launched or fall through", scenario);
    }
}

void rest_family(const Core& core, const ScenarioForm& form, Family& family) {
  if (!is_drop(form) || ends_at_zero_speed(core, 1.0 / base_dt_s(form.scenario.clock)) ||
      !(std::get<double>(form.scenario.length) > time_to_rest_s(core, form.scenario, kRestFastest_hz)))
    return;
  for (const double rate_hz :
       {20.0, 24.0, 25.0,  30.0,  48.0,  50.0,  57.5,  57.7,  60.0,  72.0,  75.0,  85.0,
        89.9, 90.0, 100.0, 120.0, 143.8, 143.9, 144.0, 165.0, 240.0, 360.0, 500.0, 1000.0}) {
    Scenario scenario = form.scenario;
    scenario.clock.base = FixedRate{rate_hz};
    HardCase& member = family.add(fmt::format("{:g}-hz", rate_hz),
                                  "gravity puts into each step what a bounce leaves", scenario);
    member.must_come_to_rest = true;
    if (!ends_at_zero_speed(core, rate_hz)) member.never_at_rest = kNoZeroSpeed;
  }
}

void zeno_family(const Core& core, const ScenarioForm& form, Family& family) {
  if (!is_drop(form) || !ends_at_zero_speed(core, 1.0 / base_dt_s(form.scenario.clock)) ||
      !(std::get<double>(form.scenario.length) > time_to_rest_s(core, form.scenario, kZenoFastest_hz)))
    return;
  for (const double rate_hz : {1e3, 4e3, 1e4}) {
    Scenario scenario = form.scenario;
    scenario.clock.base = FixedRate{rate_hz};
    const DropTimes times = drop_times(core, form.scenario, rate_hz);
    scenario.expect.emplace();
    scenario.expect->at_rest_since_s =
        Interval{0.0, (times.fall_s + times.sink_s) * times.bounces + 2.0 / rate_hz};
    HardCase& member =
        family.add(fmt::format("{:g}-hz", rate_hz),
                   "ever more bounces in ever less time must end by the sum of their series", scenario);
    member.must_come_to_rest = true;
  }
}

void any_jitter_family(const Core& core, const ScenarioForm& form, Family& family) {
  if (!(form.has_jitter(Jitter::Kind::uniform) && form.length > 0 && has_only<Fling>(form.scenario.events)))
    return;
  struct Kind {
    const char* name;
    Jitter::Kind kind;
    std::vector<double> amounts;
  };
  for (const Kind& kind : {Kind{"uniform", Jitter::Kind::uniform, {0.1, 0.5, 1.0}},
                           Kind{"normal", Jitter::Kind::normal, {0.0005, 0.002, 0.02, 1.0, 1e9}},
                           Kind{"missed", Jitter::Kind::missed_frames, {0.01, 0.05, 0.5, 1.0}}})
    for (const double amount : kind.amounts) {
      Scenario scenario = form.scenario;
      scenario.clock.jitter = Jitter{kind.kind, amount, 2026};
      family.add(fmt::format("{}-{:g}", kind.name, amount), "no two frames take the same time", scenario);
    }
  if (!(zero_speed_hz(core) >= 1.0 && zero_speed_hz(core) <= kZenoFastest_hz)) return;
  for (const double fraction : {0.001, 0.1}) {
    Scenario scenario = form.scenario;
    scenario.clock = {FixedRate{zero_speed_hz(core)}, Jitter{Jitter::Kind::uniform, fraction, 2026}};
    scenario.length = 5'000;
    scenario.events.clear();
    family.add(fmt::format("resonant-{:g}", fraction),
               "whether the floor stops the sprite changes from frame to frame", scenario);
  }
}

// The base's ten flings again and again, at its pace.
void fling_a_minute_family(const Core&, const ScenarioForm& form, Family& family) {
  if (!(form.has_jitter(Jitter::Kind::missed_frames) && form.length >= 10'000 && form.length <= 100'000 &&
        !form.scenario.events.empty() && has_only<Fling>(form.scenario.events)))
    return;
  struct Length {
    const char* name;
    std::int64_t times;
    bool is_long;
  };
  for (const Length& repeated : {Length{"an-hour", 6, false}, Length{"a-day", 144, true}}) {
    Scenario scenario = form.scenario;
    scenario.length = repeated.times * form.length;
    scenario.events.clear();
    for (std::int64_t time = 0; time < repeated.times; ++time)
      for (const Event& event : form.scenario.events)
        scenario.events.push_back({time * form.length + std::get<std::int64_t>(event.when), event.action});
    family.add(repeated.name, "many flings, one after the other: nothing may add up", scenario).is_long =
        repeated.is_long;
  }
}

// The billionths of a second as the smallest double there is.
void trace_of_extremes_family(const Core&, const ScenarioForm& form, Family& family) {
  const auto* const given = std::get_if<RecordedSteps>(&form.scenario.clock.base);
  if (given == nullptr || std::ranges::count(given->dt_s, 1e-9) == 0) return;
  Scenario scenario = form.scenario;
  RecordedSteps trace = *given;
  for (double& dt_s : trace.dt_s)
    if (dt_s == 1e-9) dt_s = std::numeric_limits<double>::denorm_min();
  scenario.clock.base = std::move(trace);
  family.add("subnormal", "frames so short that no speed moves anything", scenario);
}

// A fling every 3,000 frames: nothing repeats, and no speed has the time to become subnormal, which would
// cost three times as long.
void billion_steps_family(const Core&, const ScenarioForm& form, Family& family) {
  if (!form.is_left_alone || form.length < 10'000'000) return;
  constexpr std::int64_t kSteps = 1'000'000'000;
  Scenario scenario = form.scenario;
  scenario.length = kSteps;
  scenario.record_every = 1'000'000;
  scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.2, 9};
  for (std::int64_t frame = 0; frame < kSteps; frame += 3'000)
    scenario.events.push_back(
        {frame, Fling{{900.0 - static_cast<double>(frame % 700'000) / 400.0, -1500.0}}});
  family.add("1e9-steps", "193 days at 60 Hz, jittered, with a fling every 50 seconds", scenario).is_long =
      true;
}

}  // namespace hyrax

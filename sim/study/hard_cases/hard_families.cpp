// Which cases are made from a scenario: itself, and families by what it does, whatever its name.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/reference/whole_run.h"
#include "sim/replay/replay.h"
#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_case.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// A scenario without its expectations, what families ask of it, and their members.
struct FamilyBase {
  FamilyBase(const Core& of_core, const Scenario& given)
      : core(of_core),
        scenario(given),
        bounds(bounds_of(given.window, given.sprite)),
        start(start_state(given)),
        has_rate(std::holds_alternative<FixedRate>(given.clock.base)),
        is_steady(!given.clock.jitter && has_rate),
        is_left_alone(is_steady && given.events.empty()),
        has_room(bounds.right_px >= 1.0 && bounds.bottom_px >= 1.0),
        is_inside(has_room && start.x_px >= 0.0 && start.x_px <= bounds.right_px && start.y_px >= 0.0 &&
                  start.y_px <= bounds.bottom_px),
        is_still(start.vx_px_per_s == 0.0 && start.vy_px_per_s == 0.0) {
    if (const auto* const steps = std::get_if<std::int64_t>(&given.length)) length = *steps;
    scenario.expect.reset();
  }
  FamilyBase(const FamilyBase&) = delete;
  FamilyBase& operator=(const FamilyBase&) = delete;

  [[nodiscard]] bool has_jitter(Jitter::Kind kind) const {
    return has_rate && scenario.clock.jitter && scenario.clock.jitter->kind == kind;
  }
  // Whether all events are of the kind, and at frames.
  template <class Kind>
  [[nodiscard]] bool has_only() const {
    return std::ranges::all_of(scenario.events, [](const Event& event) {
      return std::holds_alternative<Kind>(event.action) && std::holds_alternative<std::int64_t>(event.when);
    });
  }

  // A member like the base, to be varied.
  HardCase& add(const std::string& what, const std::string& why) {
    return members.emplace_back(HardCase{
        .name = scenario.name + "/" + what, .made_from = scenario.name, .why = why, .scenario = scenario});
  }

  const Core& core;
  Scenario scenario;
  Bounds bounds;
  State start;
  bool has_rate, is_steady, is_left_alone, has_room, is_inside, is_still;
  std::int64_t length = 0;  // In frames; 0: given in seconds, or by the clock.
  std::vector<HardCase> members;
};

// What is varied in the clock and length of a scenario.

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
DropTimes drop_times(const FamilyBase& drop, double rate_hz) {
  const Constants constants = drop.core.constants.value();
  const double height_px = drop.bounds.bottom_px - drop.start.y_px;
  return {
      std::sqrt(2.0 * height_px / constants.gravity_px_per_s2),
      height_px * (1.0 - constants.air_drag) / (constants.air_drag * constants.gravity_px_per_s2 / rate_hz),
      1.0 + 2.0 * constants.restitution / (1.0 - constants.restitution)};
}

// On the floor each step of gravity adds a = drag * G * h to vy, and the bounce keeps restitution * a of it.
// The rest rule sets vy to 0 in every step if that is below its threshold, which it is above this rate; at
// other rates a two-cycle or residual speed is left. The position stands still at every rate.
double zero_speed_hz(const Core& core) {
  const Constants constants = core.constants.value();
  return constants.restitution * constants.air_drag * constants.gravity_px_per_s2 /
         constants.rest_threshold_px_per_s;
}

// Whether a sprite is dropped, ends at zero speed or does not, and has settled, and is known to have, by the
// end of the scenario, up to that rate.
bool is_drop(const FamilyBase& base, bool ends_at_zero_speed, double rate_max_hz) {
  const auto* const duration_s = std::get_if<double>(&base.scenario.length);
  if (!(base.is_left_alone && base.is_inside && base.is_still && base.start.y_px < base.bounds.bottom_px &&
        duration_s != nullptr) ||
      (1.0 / base_dt_s(base.scenario.clock) > zero_speed_hz(base.core)) != ends_at_zero_speed)
    return false;
  const DropTimes times = drop_times(base, rate_max_hz);
  return *duration_s > times.fall_s * times.bounces + times.sink_s + 1.5;
}

void add_rests(FamilyBase& base) {
  if (!is_drop(base, false, 1e3)) return;
  for (const double rate_hz :
       {20.0, 24.0, 25.0,  30.0,  48.0,  50.0,  57.5,  57.7,  60.0,  72.0,  75.0,  85.0,
        89.9, 90.0, 100.0, 120.0, 143.8, 143.9, 144.0, 165.0, 240.0, 360.0, 500.0, 1000.0}) {
    HardCase& member =
        base.add(fmt::format("{:g}-hz", rate_hz), "gravity puts into each step what a bounce leaves");
    member.scenario.clock.base = FixedRate{rate_hz};
    member.must_come_to_rest = true;
    if (!(rate_hz > zero_speed_hz(base.core))) member.never_at_rest = kNoZeroSpeed;
  }
  for (const auto& [name, jitter] : {std::pair("uniform", Jitter{Jitter::Kind::uniform, 0.5, 2026}),
                                     {"normal", Jitter{Jitter::Kind::normal, 0.002, 2026}},
                                     {"missed", Jitter{Jitter::Kind::missed_frames, 0.05, 2026}}}) {
    HardCase& member = base.add(fmt::format("uneven-{}", name), "at rest no two frames take the same time");
    member.scenario.clock = {FixedRate{60.0}, jitter};
    member.rests_from_s = std::get<double>(member.scenario.length) - 1.0;
  }
}

constexpr double kZenoFastest_hz = 1e4;

void add_zenos(FamilyBase& base) {
  if (!is_drop(base, true, kZenoFastest_hz)) return;
  for (const double rate_hz : {1e3, 4e3, kZenoFastest_hz}) {
    HardCase& member = base.add(fmt::format("{:g}-hz", rate_hz),
                                "ever more bounces in ever less time must end by the sum of their series");
    member.scenario.clock.base = FixedRate{rate_hz};
    const DropTimes times = drop_times(base, rate_hz);
    member.scenario.expect.emplace().at_rest_since_s =
        Interval{0.0, (times.fall_s + times.sink_s) * times.bounces + 2.0 / rate_hz};
    member.must_come_to_rest = true;
  }
}

void add_frames(FamilyBase& base) {
  const auto* const step = std::get_if<FixedStep>(&base.scenario.clock.base);
  if (step == nullptr || !(step->dt_s >= 0.1) || base.scenario.clock.jitter || !base.scenario.events.empty())
    return;
  for (const double dt_s :
       {0.0, 4.9406564584124654e-324, 1e-310, 1e-9, 1e-6, 1e-3, 0.02, 0.25, 0.5, 10.0, 1e3, 1e6, kFrameMax_s})
    base.add(fmt::format("dt-{:g}", dt_s), "a frame far from the sixtieth of a second that it was made for")
        .scenario.clock.base = FixedStep{dt_s};
}

// The last moment of add_hitches.
constexpr std::int64_t kHitchAtRest = 500;

// The first frame before kHitchAtRest in which the sprite lands, without its events.
std::optional<std::int64_t> first_landing(const FamilyBase& base) {
  State body = base.start;
  for (std::int64_t frame = 0; frame < kHitchAtRest - 1; ++frame) {
    body = base.core.step(body, base_dt_s(base.scenario.clock), base.bounds);
    if (body.y_px == base.bounds.bottom_px) return frame;
  }
  return std::nullopt;
}

// Whether it has been at rest for a second in a frame, without its events.
bool has_settled_by(const FamilyBase& base, std::int64_t frame) {
  Scenario scenario = base.scenario;
  scenario.events.clear();
  scenario.length = frame;
  return replay(base.core, scenario).at_rest_since_s.has_value();
}

// A hitch of half a second at each kind of moment, and of the hours for which a machine is suspended.
void add_hitches(FamilyBase& base) {
  if (!(base.is_steady && base.length > kHitchAtRest && !base.scenario.events.empty() &&
        base.has_only<Hitch>()))
    return;
  const std::optional<std::int64_t> landing = first_landing(base);
  if (!landing) return;
  for (const auto& [moment, frame] : {std::pair("in-flight", *landing * 2 / 5),
                                      {"before-contact", *landing - 1},
                                      {"at-contact", *landing},
                                      {"after-contact", *landing + 1},
                                      {"at-rest", kHitchAtRest}})
    for (const double dt_s : {0.5, 3600.0, 28800.0}) {
      HardCase& member = base.add(fmt::format("{}-{:g}-s", moment, dt_s),
                                  "one frame takes long: nothing may be launched or fall through");
      member.scenario.events = {{frame, Hitch{dt_s}}};
      if (frame != kHitchAtRest || !base.core.constants || !has_settled_by(base, frame)) continue;
      member.rests_from_s = static_cast<double>(frame) * base_dt_s(base.scenario.clock);
      // It falls for so long and is turned at the frame's end: that throws it so high.
      const Constants laws = base.core.constants.value();
      const double up_s = laws.restitution * laws.air_drag * dt_s;
      if (up_s * up_s * laws.gravity_px_per_s2 / 2.0 > 1.0)
        member.thrown_at_rest =
            "at rest, a long frame throws the sprite up: it falls for as long before the floor turns it";
    }
}

void add_jitters(FamilyBase& base) {
  if (!(base.has_jitter(Jitter::Kind::uniform) && base.length > 0 && base.has_only<Fling>())) return;
  struct Kind {
    const char* name;
    Jitter::Kind kind;
    std::vector<double> amounts;
  };
  for (const Kind& kind : {Kind{"uniform", Jitter::Kind::uniform, {0.1, 0.5, 1.0}},
                           Kind{"normal", Jitter::Kind::normal, {0.0005, 0.002, 0.02, 1.0, 1e9}},
                           Kind{"missed", Jitter::Kind::missed_frames, {0.01, 0.05, 0.5, 1.0}}})
    for (const double amount : kind.amounts)
      base.add(fmt::format("{}-{:g}", kind.name, amount), "no two frames take the same time")
          .scenario.clock.jitter = Jitter{kind.kind, amount, 2026};
  const double resonant_hz = base.core.constants ? zero_speed_hz(base.core) : 0.0;
  if (!(resonant_hz >= 1.0 && resonant_hz <= kZenoFastest_hz)) return;
  for (const double fraction : {0.001, 0.1}) {
    Scenario& scenario = base.add(fmt::format("resonant-{:g}", fraction),
                                  "whether the floor stops the sprite changes from frame to frame")
                             .scenario;
    scenario.clock = {FixedRate{resonant_hz}, Jitter{Jitter::Kind::uniform, fraction, 2026}};
    scenario.length = 5'000;
    scenario.events.clear();
  }
}

// The base's ten flings again and again, at its pace.
void add_repeated_flings(FamilyBase& base) {
  if (!(base.has_jitter(Jitter::Kind::missed_frames) && base.length >= 10'000 && base.length <= 100'000 &&
        !base.scenario.events.empty() && base.has_only<Fling>()))
    return;
  for (const auto& [name, times] : {std::pair("an-hour", 6), {"a-day", 144}}) {
    HardCase& member = base.add(name, "many flings, one after the other: nothing may add up");
    member.is_long = times > 6;
    member.scenario.length = times * base.length;
    for (int time = 1; time < times; ++time)
      for (const Event& event : base.scenario.events)
        member.scenario.events.push_back(
            {time * base.length + std::get<std::int64_t>(event.when), event.action});
  }
}

// Each of the base's flings on its own, for as long, with nothing to take its energy but the step itself.
void add_lossless_bounces(FamilyBase& base) {
  if (!(base.has_jitter(Jitter::Kind::missed_frames) && base.length >= 10'000 && base.length <= 100'000 &&
        !base.scenario.events.empty() && base.has_only<Fling>()))
    return;
  const double duration_s = static_cast<double>(base.length) * base_dt_s(base.scenario.clock);
  for (std::size_t each = 0; each < base.scenario.events.size(); ++each)
    for (const double rate_hz : {24.0, 60.0, 144.0, 240.0}) {
      HardCase& member = base.add(fmt::format("lossless-{}-{:g}-hz", each + 1, rate_hz),
                                  "bounces without loss: nothing may take the energy away");
      member.is_lossless = true;
      member.scenario.clock = {FixedRate{rate_hz}, {}};
      member.scenario.length = duration_s;
      member.scenario.start_velocity = std::get<Fling>(base.scenario.events[each].action).velocity;
      member.scenario.events.clear();
    }
}

// The billionths of a second as the smallest double there is.
void add_subnormal_frames(FamilyBase& base) {
  const auto* const given = std::get_if<RecordedSteps>(&base.scenario.clock.base);
  if (given == nullptr || std::ranges::count(given->dt_s, 1e-9) == 0) return;
  RecordedSteps trace = *given;
  std::ranges::replace(trace.dt_s, 1e-9, std::numeric_limits<double>::denorm_min());
  base.add("subnormal", "frames so short that no speed moves anything").scenario.clock.base =
      std::move(trace);
}

// A fling every 3,000 frames: nothing repeats, and no speed has the time to become subnormal, which would
// cost three times as long.
void add_billion_steps(FamilyBase& base) {
  if (!base.is_left_alone || base.length < 10'000'000) return;
  constexpr std::int64_t kSteps = 1'000'000'000;
  HardCase& member = base.add("1e9-steps", "193 days at 60 Hz, jittered, with a fling every 50 seconds");
  member.is_long = true;
  Scenario& scenario = member.scenario;
  scenario.length = kSteps;
  scenario.record_every = 1'000'000;
  scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.2, 9};
  for (std::int64_t frame = 0; frame < kSteps; frame += 3'000)
    scenario.events.push_back(
        {frame, Fling{{900.0 - static_cast<double>(frame % 700'000) / 400.0, -1500.0}}});
}

// What is varied in its places and speeds.

// On each bound, and one double to each side of it, moving away, along and into it.
void add_places_on_bounds(FamilyBase& base) {
  if (!(base.is_steady && base.is_inside && base.is_still && base.length > 90 &&
        base.start.y_px == base.bounds.bottom_px && base.has_only<Fling>()))
    return;
  struct Bound {
    const char* name;
    bool is_in_x;
    double at_px;
  };
  for (const Bound bound : {Bound{"left", true, 0.0}, Bound{"right", true, base.bounds.right_px},
                            Bound{"top", false, 0.0}, Bound{"ground", false, base.bounds.bottom_px}})
    for (const auto& [side, towards] :
         {std::pair("-less-an-ulp", -HUGE_VAL), {"", bound.at_px}, {"-and-an-ulp", HUGE_VAL}}) {
      Scenario& scenario =
          base.add(std::string(bound.name) + side,
                   "on a bound, or next to it, still, inward and outward: one contact or none, never two")
              .scenario;
      (bound.is_in_x ? scenario.start.x_px : scenario.start.y_px) = std::nextafter(bound.at_px, towards);
      scenario.events.clear();
      for (const auto& [frame, speed_px_per_s] : {std::pair(std::int64_t{30}, 700.0), {90, -700.0}}) {
        scenario.events.push_back({frame, Place{scenario.start}});
        scenario.events.push_back(
            {frame, Fling{bound.is_in_x ? Velocity{speed_px_per_s, 0.0} : Velocity{0.0, speed_px_per_s}}});
      }
    }
}

// The highest point of the start's flight in 600 frames, from a start at 0: at most 0.
double apex_px(const FamilyBase& base) {
  State body{0.0, 0.0, base.start.vx_px_per_s, base.start.vy_px_per_s};
  double apex_px = 0.0;
  for (int frame = 0; frame < 600; ++frame) {
    body = base.core.flight(body, base_dt_s(base.scenario.clock));
    apex_px = std::fmin(apex_px, body.y_px);
  }
  return apex_px;
}

// The apex of a throw at the ceiling: the start height at which the paper's step just reaches it, and doubles
// around it.
void add_grazings(FamilyBase& base) {
  if (!(base.is_left_alone && base.is_inside && base.start.vy_px_per_s < 0.0)) return;
  const double highest_px = apex_px(base);
  if (!(std::fabs(base.start.y_px + highest_px) < 20.0)) return;
  for (const double off_px : {-1e-3, -1e-9, -1e-13, 0.0, 1e-13, 1e-9, 1e-3})
    base.add(fmt::format("off-{:g}-px", off_px),
             "the ceiling is met with no speed left: a root of even order")
        .scenario.start.y_px = off_px - highest_px;
}

// From the middle of the room, so that the exact fling meets both walls of a corner at one time.
void add_exact_corner(FamilyBase& base, bool is_right, bool is_low) {
  const FixedLaws laws(reference_model(base.core));
  const auto [right_px, bottom_px] = base.bounds;
  const Position middle{right_px / 2, bottom_px / 2};
  // So soon that it neither turns on its way nor is all but stopped.
  const double t_s =
      std::min({0.5, std::sqrt(middle.y_px / (2 * laws.gravity_px_per_s2)), 1.0 / laws.drag_rate_per_s});
  const double way_px = fly(1.0, 0.0, laws.drag_rate_per_s, t_s).displacement_px;
  const double fall_px = fly(0.0, laws.gravity_px_per_s2, laws.drag_rate_per_s, t_s).displacement_px;
  HardCase& member =
      base.add(fmt::format("exact-{}-{}", is_low ? "lower" : "upper", is_right ? "right" : "left"),
               "both walls at one time, by the exact fling");
  member.scenario.start = middle;
  member.scenario.start_velocity = {(is_right ? middle.x_px : -middle.x_px) / way_px,
                                    ((is_low ? middle.y_px : -middle.y_px) - fall_px) / way_px};
  member.exact_corner = static_cast<std::uint8_t>(is_right ? Wall::right : Wall::left) |
                        static_cast<std::uint8_t>(is_low ? Wall::ground : Wall::top);
}

void add_corners(FamilyBase& base) {
  const auto near = [](double at_px, double speed_px_per_s, double far_px) {
    return (speed_px_per_s > 0.0 ? far_px - at_px : at_px) <= 20.0;
  };
  const State& s = base.start;
  const auto [right_px, bottom_px] = base.bounds;
  if (!(base.is_left_alone && base.is_inside && !base.is_still &&
        std::fabs(s.vx_px_per_s) == std::fabs(s.vy_px_per_s) && near(s.x_px, s.vx_px_per_s, right_px) &&
        near(s.y_px, s.vy_px_per_s, bottom_px)))
    return;
  for (const bool is_right : {false, true})
    for (const bool is_low : {false, true}) {
      if (base.core.constants && why_no_exact_fling(reference_model(base.core)).empty())
        add_exact_corner(base, is_right, is_low);
      for (const std::string_view where : {"in-it", "an-ulp-from-it", "into-it"}) {
        const auto inside = [where](double corner_px, double other_px) {
          if (where == "in-it") return corner_px;
          if (where == "into-it") return corner_px + std::copysign(10.0, other_px - corner_px);
          return std::nextafter(corner_px, other_px);
        };
        Scenario& scenario =
            base.add(fmt::format("{}-{}-{}", is_low ? "lower" : "upper", is_right ? "right" : "left", where),
                     "both walls in one frame")
                .scenario;
        scenario.start = {is_right ? inside(right_px, 0.0) : inside(0.0, right_px),
                          is_low ? inside(bottom_px, 0.0) : inside(0.0, bottom_px)};
        scenario.start_velocity = {std::copysign(s.vx_px_per_s, is_right ? 1.0 : -1.0),
                                   std::copysign(s.vy_px_per_s, is_low ? 1.0 : -1.0)};
      }
    }
}

void add_speeds(FamilyBase& base) {
  if (!(base.is_left_alone && base.is_inside &&
        std::max(std::fabs(base.start.vx_px_per_s), std::fabs(base.start.vy_px_per_s)) >= 1e5))
    return;
  for (const double speed_px_per_s :
       {4.9406564584124654e-324, 1e-310, 1e-300, 1e-150, 1e-9, 1.0, 1e4, 1e6, 1e9, kSpeedMax_px_per_s})
    base.add(fmt::format("v-{:g}", speed_px_per_s), "a speed far from that of any throw")
        .scenario.start_velocity = {speed_px_per_s, -speed_px_per_s};
  constexpr Velocity kFast{1e4, -1e4};
  const Size sprite = base.scenario.sprite;
  Scenario& narrow = base.add("room-of-2-px", "each frame passes the room many times").scenario;
  narrow.window = {sprite.width_px + 2, sprite.height_px + 2};
  narrow.start = {1.0, 1.0};
  narrow.start_velocity = kFast;
  Scenario& wide =
      base.add("1e6-px-at-1-mhz", "steps so short that a place of a million px rounds what they add")
          .scenario;
  wide.window = {1'000'000, 1'000'000};
  wide.start = {wide.window.width_px - sprite.width_px - 1.0, 1.0};
  wide.start_velocity = kFast;
  wide.clock.base = FixedRate{1e6};
}

void add_starts_outside(FamilyBase& base) {
  if (!(base.is_left_alone && base.has_room &&
        std::max(std::fabs(base.start.x_px), std::fabs(base.start.y_px)) >= 1e8))
    return;
  for (const double away_px : {1e3, 1e9, kCoordinateMax_px})
    for (const auto& [side, axis, sign] : {std::tuple("left", &Position::x_px, -1.0),
                                           {"right", &Position::x_px, 1.0},
                                           {"above", &Position::y_px, -1.0},
                                           {"below", &Position::y_px, 1.0}})
      base.add(fmt::format("{}-{:g}-px", side, away_px), "a start far outside the window").scenario.start.*
          axis = sign * away_px;
}

struct Family {
  void (*add_members)(FamilyBase&);
  bool needs_constants = false;
};
// In the order in which their cases are played.
constexpr Family kFamilies[] = {{add_repeated_flings},  {add_lossless_bounces, true},
                                {add_frames},           {add_jitters},
                                {add_speeds},           {add_corners},
                                {add_starts_outside},   {add_grazings, true},
                                {add_hitches},          {add_places_on_bounds},
                                {add_rests, true},      {add_billion_steps},
                                {add_subnormal_frames}, {add_zenos, true}};

// Whether the run ends with a sprite that is larger than its window and is not held.
bool is_larger_than_window(const Scenario& scenario) {
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  for (const Event& event : scenario.events) apply(event.action, world);
  return !world.is_held && (world.bounds().right_px < 0.0 || world.bounds().bottom_px < 0.0);
}

// On the floor each frame leaves 0.7992 of vx (drag and friction): 1e12 px/s are at the least double after
// some 3,400 frames. Factors above one half round it up again there.
bool slides_to_subnormal_speed(const FamilyBase& base) {
  const Constants laws = base.core.constants.value();
  const double frames =
      (std::log(std::fabs(base.start.vx_px_per_s)) - std::log(std::numeric_limits<double>::denorm_min())) /
      -std::log(laws.air_drag * laws.ground_friction);
  return base.is_left_alone && base.is_inside && std::min(laws.air_drag, laws.ground_friction) > 0.5 &&
         static_cast<double>(step_count(base.scenario)) >= frames &&
         base.start.y_px == base.bounds.bottom_px && base.start.vy_px_per_s == 0.0 &&
         base.start.vx_px_per_s != 0.0;
}

}  // namespace

std::vector<HardCase> hard_cases_of(const Core& core, const Scenario& scenario) {
  FamilyBase base(core, scenario);
  HardCase itself{.name = scenario.name,
                  .made_from = scenario.name,
                  .why = scenario.description.value_or(""),
                  .scenario = scenario};
  if (core.constants && is_larger_than_window(scenario))
    itself.never_at_rest =
        "the sprite is larger than the window: it jumps from wall to wall forever, without any input";
  else if (core.constants && slides_to_subnormal_speed(base))
    itself.never_at_rest = "vx becomes subnormal and stays so, never 0; the position stands still";
  itself.must_come_to_rest = !itself.never_at_rest.empty();
  itself.is_long = base.length > 1'000'000;
  base.members.push_back(std::move(itself));
  for (const Family& family : kFamilies)
    if (core.constants || !family.needs_constants) family.add_members(base);
  return std::move(base.members);
}

}  // namespace hyrax

// The families of hard cases: what is varied in the scenario that bears the family's name.
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

#include "sim/study/core.h"
#include "sim/study/hard_case.h"

namespace hyrax {
namespace {

using Cases = std::vector<HardCase>;

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// Builds the members of one family.
class Family {
 public:
  explicit Family(const Scenario& base) : base_(base) { base_.expect.reset(); }

  [[nodiscard]] const Scenario& base() const { return base_; }
  HardCase& add(const std::string& what, const std::string& why, const Scenario& scenario) {
    HardCase member{.name = base_.name + "/" + what,
                    .made_from = base_.name,
                    .why = why,
                    .scenario = scenario,
                    .findings = {}};
    member.scenario.name = base_.name;
    cases_.push_back(std::move(member));
    return cases_.back();
  }
  [[nodiscard]] Cases take() { return std::move(cases_); }

 private:
  Scenario base_;
  Cases cases_;
};

const char kNoTimeDamps[] = "drag acts once a frame, even in a frame of no time";

Cases any_frame(const Scenario& base) {
  Family family(base);
  for (const double dt_s : {0.0, 4.9406564584124654e-324, 1e-310, 1e-9, 1e-6, 1e-3, 0.02, 0.25, 0.5, 10.0,
                            1e3, 1e6, kFrameMax_s}) {
    Scenario scenario = family.base();
    scenario.clock.base = FixedStep{dt_s};
    HardCase& member = family.add("dt-" + text_of(dt_s),
                                  "a frame far from the sixtieth of a second that it was made for", scenario);
    if (dt_s == 0.0) member.findings = {{Invariant::no_time, kNoTimeDamps}};
  }
  return family.take();
}

// A hitch of half a second at each kind of moment, and of no time and an hour.
Cases hitch(const Scenario& base) {
  Family family(base);
  struct Moment {
    const char* name;
    std::int64_t frame;
  };
  for (const Moment moment :
       {Moment{"in-flight", 40}, Moment{"before-contact", 101}, Moment{"at-contact", 102},
        Moment{"after-contact", 103}, Moment{"at-rest", 500}})
    for (const double dt_s : {0.5, 3600.0}) {
      Scenario scenario = family.base();
      scenario.events = {{moment.frame, Hitch{dt_s}}};
      family.add(std::string(moment.name) + "-" + text_of(dt_s) + "-s",
                 "one frame takes long: nothing may be launched or fall through", scenario);
    }
  return family.take();
}

// On each bound, and one double to each side of it, moving away, along and into it.
Cases on_a_bound(const Scenario& base) {
  Family family(base);
  const double right_px = base.window.width_px - base.sprite.width_px;
  const double bottom_px = base.window.height_px - base.sprite.height_px;
  struct Bound {
    const char* name;
    bool is_in_x;
    double at_px;
  };
  for (const Bound bound : {Bound{"left", true, 0.0}, Bound{"right", true, right_px},
                            Bound{"top", false, 0.0}, Bound{"ground", false, bottom_px}})
    for (const int ulps : {-1, 0, 1}) {
      Scenario scenario = family.base();
      scenario.events.clear();
      double& at_px = bound.is_in_x ? scenario.start.x_px : scenario.start.y_px;
      const double far = std::numeric_limits<double>::infinity();
      at_px = ulps == 0 ? bound.at_px : std::nextafter(bound.at_px, ulps * far);
      const auto fling = [&](std::int64_t frame, double speed_px_per_s) {
        const Velocity velocity =
            bound.is_in_x ? Velocity{speed_px_per_s, 0.0} : Velocity{0.0, speed_px_per_s};
        scenario.events.push_back({frame, Place{scenario.start}});
        scenario.events.push_back({frame, Fling{velocity}});
      };
      fling(30, 700.0);
      fling(90, -700.0);
      family.add(std::string(bound.name) + (ulps == 0  ? ""
                                            : ulps < 0 ? "-less-an-ulp"
                                                       : "-and-an-ulp"),
                 "on a bound, or next to it, still, inward and outward: one contact or none, never two",
                 scenario);
    }
  return family.take();
}

// The apex of a throw at the ceiling: the start height at which the paper's step just reaches it, and doubles
// around it. Found by flying once, from anywhere.
Cases grazing(const Scenario& base) {
  Family family(base);
  const double dt_s = 1.0 / std::get<FixedRate>(base.clock.base).rate_hz;
  Body body{0.0, 0.0, base.start_velocity.vx_px_per_s, base.start_velocity.vy_px_per_s};
  double apex_px = 0.0;
  for (int frame = 0; frame < 600; ++frame) {
    body = core_flight(body, dt_s);
    apex_px = std::fmin(apex_px, body.y_px);
  }
  for (const double off_px : {-1e-3, -1e-9, -1e-13, 0.0, 1e-13, 1e-9, 1e-3}) {
    Scenario scenario = family.base();
    scenario.start.y_px = off_px - apex_px;
    family.add("off-" + text_of(off_px) + "-px",
               "the ceiling is met with no speed left: a root of even order", scenario);
  }
  return family.take();
}

Cases corners(const Scenario& base) {
  Family family(base);
  const double right_px = base.window.width_px - base.sprite.width_px;
  const double bottom_px = base.window.height_px - base.sprite.height_px;
  for (const bool is_right : {false, true})
    for (const bool is_low : {false, true})
      for (const double inset_px : {0.0, 10.0}) {
        Scenario scenario = family.base();
        scenario.start = {is_right ? right_px - inset_px : inset_px,
                          is_low ? bottom_px - inset_px : inset_px};
        scenario.start_velocity.vx_px_per_s *= is_right ? 1.0 : -1.0;
        scenario.start_velocity.vy_px_per_s *= is_low ? 1.0 : -1.0;
        family.add(std::string(is_low ? "lower" : "upper") + (is_right ? "-right" : "-left") +
                       (inset_px == 0.0 ? "-in-it" : "-into-it"),
                   "both walls in one frame", scenario);
      }
  return family.take();
}

Cases any_speed(const Scenario& base) {
  Family family(base);
  for (const double speed_px_per_s :
       {4.9406564584124654e-324, 1e-310, 1e-300, 1e-150, 1e-9, 1.0, 1e4, 1e6, 1e9, kSpeedMax_px_per_s}) {
    Scenario scenario = family.base();
    scenario.start_velocity = {speed_px_per_s, -speed_px_per_s};
    family.add("v-" + text_of(speed_px_per_s), "a speed that no hand gives", scenario);
  }
  return family.take();
}

Cases far_outside(const Scenario& base) {
  Family family(base);
  for (const double away_px : {1e3, 1e9, kCoordinateMax_px})
    for (const int side : {0, 1, 2, 3}) {
      Scenario scenario = family.base();
      const double sign = side % 2 == 0 ? -1.0 : 1.0;
      (side < 2 ? scenario.start.x_px : scenario.start.y_px) = sign * away_px;
      family.add(std::string(side < 2 ? (side == 0 ? "left" : "right") : (side == 2 ? "above" : "below")) +
                     "-" + text_of(away_px) + "-px",
                 "a start that no window holds", scenario);
    }
  return family.take();
}

// Analytic: on the floor each step of gravity gives a = drag * G * h, and the bounce keeps restitution * a of
// it; where that is below the threshold the rest rule ends it, at every other rate nothing does.
bool ends_at_rest(double rate_hz) {
  const CoreConstants core = core_constants();
  return core.restitution * core.air_drag * core.gravity_px_per_s2 / rate_hz < core.rest_threshold_px_per_s;
}

Cases rest(const Scenario& base) {
  Family family(base);
  for (const double rate_hz :
       {20.0, 24.0, 25.0,  30.0,  48.0,  50.0,  57.5,  57.7,  60.0,  72.0,  75.0,  85.0,
        89.9, 90.0, 100.0, 120.0, 143.8, 143.9, 144.0, 165.0, 240.0, 360.0, 500.0, 1000.0}) {
    Scenario scenario = family.base();
    scenario.clock.base = FixedRate{rate_hz};
    HardCase& member =
        family.add(text_of(rate_hz) + "-hz", "gravity puts into each step what a bounce leaves", scenario);
    member.asks_rest = true;
    if (!ends_at_rest(rate_hz))
      member.findings = {
          {Invariant::comes_to_rest,
           "it stands on the floor and buzzes for ever: a step of gravity outdoes the threshold"}};
  }
  return family.take();
}

Cases zeno(const Scenario& base) {
  Family family(base);
  for (const double rate_hz : {1e3, 4e3, 1e4}) {
    Scenario scenario = family.base();
    scenario.clock.base = FixedRate{rate_hz};
    // Falling from rest takes t1 = sqrt(2 H / G); all bounces then 2 t1 b / (1 - b), with drag less. Where
    // the frames drag so often that it sinks instead of falling, H / terminal speed comes on top.
    const CoreConstants core = core_constants();
    const double height_px = base.window.height_px - base.sprite.height_px - base.start.y_px;
    const double fall_s = std::sqrt(2.0 * height_px / core.gravity_px_per_s2);
    const double sink_s =
        height_px * (1.0 - core.air_drag) / (core.air_drag * core.gravity_px_per_s2 / rate_hz);
    const double bounce = core.restitution;
    scenario.expect.emplace();
    scenario.expect->at_rest_since_s =
        Interval{0.0, (fall_s + sink_s) * (1.0 + 2.0 * bounce / (1.0 - bounce)) + 2.0 / rate_hz};
    HardCase& member =
        family.add(text_of(rate_hz) + "-hz",
                   "ever more bounces in ever less time must end by the sum of their series", scenario);
    member.asks_rest = true;
  }
  return family.take();
}

Cases any_jitter(const Scenario& base) {
  Family family(base);
  struct Kind {
    const char* name;
    Jitter::Kind kind;
    std::vector<double> amounts;
  };
  for (const Kind& kind : {Kind{"uniform", Jitter::Kind::uniform, {0.1, 0.5, 1.0}},
                           Kind{"normal", Jitter::Kind::normal, {0.0005, 0.002, 0.02, 1.0, 1e9}},
                           Kind{"missed", Jitter::Kind::missed_frames, {0.01, 0.05, 0.5, 1.0}}})
    for (const double amount : kind.amounts) {
      Scenario scenario = family.base();
      scenario.clock.jitter = Jitter{kind.kind, amount, 2026};
      HardCase& member = family.add(std::string(kind.name) + "-" + text_of(amount),
                                    "no two frames take the same time", scenario);
      // Normal jitter of this size draws frames of no time.
      if (kind.kind == Jitter::Kind::normal && amount >= 0.02)
        member.findings = {{Invariant::no_time, kNoTimeDamps}};
    }
  return family.take();
}

// The base's ten flings again and again, at its pace.
Cases fling_a_minute(const Scenario& base) {
  Family family(base);
  const auto steps = std::get<std::int64_t>(base.length);
  struct Length {
    const char* name;
    std::int64_t times;
    bool is_long;
  };
  for (const Length length : {Length{"an-hour", 6, false}, Length{"a-day", 144, true}}) {
    Scenario scenario = family.base();
    scenario.length = length.times * steps;
    scenario.events.clear();
    for (std::int64_t time = 0; time < length.times; ++time)
      for (const Event& event : base.events)
        scenario.events.push_back({time * steps + std::get<std::int64_t>(event.when), event.action});
    family.add(length.name, "many flings, one after the other: nothing may add up", scenario).is_long =
        length.is_long;
  }
  return family.take();
}

// A fling every 100,000 frames, so that nothing repeats for long.
Cases billion_steps(const Scenario& base) {
  Family family(base);
  constexpr std::int64_t kSteps = 1'000'000'000;
  Scenario scenario = family.base();
  scenario.length = kSteps;
  scenario.record_every = 1'000'000;
  scenario.clock.jitter = Jitter{Jitter::Kind::uniform, 0.2, 9};
  for (std::int64_t frame = 0; frame < kSteps; frame += 100'000)
    scenario.events.push_back(
        {frame, Fling{{900.0 - static_cast<double>(frame % 700'000) / 400.0, -1500.0}}});
  family.add("1e9-steps", "193 days at 60 Hz, jittered, with a fling every 28 minutes", scenario).is_long =
      true;
  return family.take();
}

struct NamedFamily {
  std::string_view base;
  Cases (*make)(const Scenario& base);
};

constexpr NamedFamily kFamilies[] = {
    {"a-fling-a-minute", fling_a_minute},
    {"any-frame", any_frame},
    {"any-jitter", any_jitter},
    {"any-speed", any_speed},
    {"corners", corners},
    {"far-outside", far_outside},
    {"grazing", grazing},
    {"hitch", hitch},
    {"on-a-bound", on_a_bound},
    {"rest", rest},
    {"ten-million-steps", billion_steps},
    {"zeno", zeno},
};

// What is known not to hold in the scenarios themselves.
struct KnownFinding {
  std::string_view scenario;
  Invariant invariant;
  const char* what;
};

constexpr char kBothWalls[] = "two walls claim the sprite, and the left one always wins";
constexpr char kNeverZero[] = "its horizontal speed goes subnormal and sticks at 1e-323 px/s, never 0";
constexpr char kNeverStill[] = "it is thrown from bound to bound for ever, without an input";

const KnownFinding kKnown[] = {
    {"clock-in-ticks", Invariant::no_time, kNoTimeDamps},
    {"frames-of-no-time", Invariant::no_time, kNoTimeDamps},
    {"subnormal-speed", Invariant::comes_to_rest, kNeverZero},
    {"subnormal-speed-in-flight", Invariant::no_time, kNoTimeDamps},
    {"trace-of-extremes", Invariant::no_time, kNoTimeDamps},
    {"sprite-far-larger-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-higher-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-wider-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-wider-than-window", Invariant::mirror, kBothWalls},
    {"sprite-larger-than-window", Invariant::mirror, kBothWalls},
    {"sprite-larger-than-window", Invariant::comes_to_rest, kNeverStill},
};

}  // namespace

std::vector<HardCase> hard_cases_of(const Scenario& scenario) {
  HardCase itself{.name = scenario.name,
                  .made_from = scenario.name,
                  .why = scenario.description.value_or(""),
                  .scenario = scenario,
                  .findings = {}};
  for (const KnownFinding& known : kKnown)
    if (known.scenario == scenario.name) {
      itself.findings.push_back({known.invariant, known.what});
      itself.asks_rest |= known.invariant == Invariant::comes_to_rest;
    }
  itself.is_long = std::holds_alternative<std::int64_t>(scenario.length) &&
                   std::get<std::int64_t>(scenario.length) > 1'000'000;
  std::vector<HardCase> cases{std::move(itself)};
  for (const NamedFamily& family : kFamilies)
    if (family.base == scenario.name)
      for (HardCase& member : family.make(scenario)) cases.push_back(std::move(member));
  return cases;
}

}  // namespace hyrax

// Which cases a scenario stands for: itself, and the family that bears its name.
#include <string_view>

#include "sim/study/hard_cases/hard_family.h"

namespace hyrax {
namespace {

struct NamedFamily {
  std::string_view base;
  std::vector<HardCase> (*make)(const Scenario& base);
};

constexpr NamedFamily kFamilies[] = {
    {"a-fling-a-minute", fling_a_minute_family},
    {"any-frame", any_frame_family},
    {"any-jitter", any_jitter_family},
    {"any-speed", any_speed_family},
    {"corners", corners_family},
    {"far-outside", far_outside_family},
    {"grazing", grazing_family},
    {"hitch", hitch_family},
    {"on-a-bound", on_a_bound_family},
    {"rest", rest_family},
    {"ten-million-steps", billion_steps_family},
    {"trace-of-extremes", trace_of_extremes_family},
    {"zeno", zeno_family},
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

// A scenario of the user's own may bear a family's name and be of another form: then it is but itself.
bool has_form_of(const Scenario& scenario, std::string_view family) {
  for (const Event& event : scenario.events)
    if (!std::holds_alternative<std::int64_t>(event.when)) return false;
  if (family == "trace-of-extremes") return std::holds_alternative<RecordedSteps>(scenario.clock.base);
  if (family == "any-frame") return std::holds_alternative<FixedStep>(scenario.clock.base);
  return std::holds_alternative<FixedRate>(scenario.clock.base);
}

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
    if (family.base == scenario.name && has_form_of(scenario, family.base))
      for (HardCase& member : family.make(scenario)) cases.push_back(std::move(member));
  return cases;
}

}  // namespace hyrax

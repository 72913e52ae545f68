// Which cases are made from a scenario: itself, and the family of its name.
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

// Expected failures of the scenarios themselves.
struct KnownFailure {
  std::string_view scenario;
  Invariant invariant;
  const char* what;
};

constexpr char kBothWalls[] =
    "the sprite is wider than the window: both side walls clamp it, and the left one always wins";
constexpr char kNeverZero[] =
    "vx becomes subnormal and stays at 1e-323 px/s, never 0; the position stands still";
constexpr char kNeverStill[] =
    "the sprite is larger than the window: it jumps from wall to wall forever, without any input";

const KnownFailure kKnown[] = {
    {"clock-in-ticks", Invariant::no_time, kDragWithoutTime},
    {"frames-of-no-time", Invariant::no_time, kDragWithoutTime},
    {"subnormal-speed", Invariant::comes_to_rest, kNeverZero},
    {"subnormal-speed-in-flight", Invariant::no_time, kDragWithoutTime},
    {"trace-of-extremes", Invariant::no_time, kDragWithoutTime},
    {"sprite-far-larger-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-higher-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-wider-than-window", Invariant::comes_to_rest, kNeverStill},
    {"sprite-wider-than-window", Invariant::mirror, kBothWalls},
    {"sprite-larger-than-window", Invariant::mirror, kBothWalls},
    {"sprite-larger-than-window", Invariant::comes_to_rest, kNeverStill},
};

// A scenario of the user's own may have a family's name and another form: then it is a single case.
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
                  .expected_failures = {}};
  for (const KnownFailure& known : kKnown)
    if (known.scenario == scenario.name) {
      itself.expected_failures.push_back({known.invariant, known.what});
      itself.must_come_to_rest |= known.invariant == Invariant::comes_to_rest;
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

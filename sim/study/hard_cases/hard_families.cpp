// Which cases are made from a scenario: itself, and families by what it does, whatever its name.
#include <algorithm>
#include <cmath>

#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_family.h"

namespace hyrax {
namespace {

constexpr char kNeverZero[] =
    "vx becomes subnormal and stays at 1e-323 px/s, never 0; the position stands still";
constexpr char kNeverStill[] =
    "the sprite is larger than the window: it jumps from wall to wall forever, without any input";

template <class Kind>
bool has_only(const std::vector<Event>& events) {
  return std::all_of(events.begin(), events.end(), [](const Event& event) {
    return std::holds_alternative<Kind>(event.action) && std::holds_alternative<std::int64_t>(event.when);
  });
}

// What predicates ask of a scenario.
struct ScenarioForm {
  explicit ScenarioForm(const Scenario& base)
      : scenario(base),
        bounds(bounds_of(base.window, base.sprite)),
        start(start_state(base)),
        has_rate(std::holds_alternative<FixedRate>(base.clock.base)),
        is_steady(!base.clock.jitter && has_rate),
        is_left_alone(is_steady && base.events.empty()),
        has_room(bounds.right_px >= 1.0 && bounds.bottom_px >= 1.0),
        is_inside(start.x_px >= 0.0 && start.x_px <= bounds.right_px && start.y_px >= 0.0 &&
                  start.y_px <= bounds.bottom_px),
        is_still(start.vx_px_per_s == 0.0 && start.vy_px_per_s == 0.0) {
    if (const auto* const steps = std::get_if<std::int64_t>(&base.length)) length = *steps;
  }

  [[nodiscard]] bool has_jitter(Jitter::Kind kind) const {
    return has_rate && scenario.clock.jitter && scenario.clock.jitter->kind == kind;
  }

  const Scenario& scenario;
  Bounds bounds;
  State start;
  bool has_rate, is_steady, is_left_alone, has_room, is_inside, is_still;
  std::int64_t length = 0;  // In frames; 0: given in seconds, or by the clock.
};

bool is_throw_in_long_frames(const Core&, const ScenarioForm& form) {
  const auto* const step = std::get_if<FixedStep>(&form.scenario.clock.base);
  return step != nullptr && step->dt_s >= 0.1 && !form.scenario.clock.jitter && form.scenario.events.empty();
}
bool is_trace_with_a_billionth(const Core&, const ScenarioForm& form) {
  const auto* const trace = std::get_if<RecordedSteps>(&form.scenario.clock.base);
  return trace != nullptr && std::count(trace->dt_s.begin(), trace->dt_s.end(), 1e-9) > 0;
}
bool lands_after_hitches(const Core& core, const ScenarioForm& form) {
  return form.is_steady && form.length > kHitchAtRest && !form.scenario.events.empty() &&
         has_only<Hitch>(form.scenario.events) && first_landing(core, form.scenario);
}
bool is_drop(const ScenarioForm& form) {
  return form.is_left_alone && form.has_room && form.is_inside && form.is_still &&
         form.start.y_px < form.bounds.bottom_px && std::holds_alternative<double>(form.scenario.length);
}
bool is_drop_to_residual_speed(const Core& core, const ScenarioForm& form) {
  return is_drop(form) && !ends_at_zero_speed(core, 1.0 / base_dt_s(form.scenario.clock)) &&
         std::get<double>(form.scenario.length) > time_to_rest_s(core, form.scenario, kRestFastest_hz);
}
bool is_drop_to_zero_speed(const Core& core, const ScenarioForm& form) {
  return is_drop(form) && ends_at_zero_speed(core, 1.0 / base_dt_s(form.scenario.clock)) &&
         std::get<double>(form.scenario.length) > time_to_rest_s(core, form.scenario, kZenoFastest_hz);
}
bool is_flung_with_jitter(const Core&, const ScenarioForm& form) {
  return form.has_jitter(Jitter::Kind::uniform) && form.length > 0 && has_only<Fling>(form.scenario.events);
}
bool is_flung_for_minutes(const Core&, const ScenarioForm& form) {
  return form.has_jitter(Jitter::Kind::missed_frames) && form.length >= 10'000 && form.length <= 100'000 &&
         !form.scenario.events.empty() && has_only<Fling>(form.scenario.events);
}
bool is_left_alone_for_days(const Core&, const ScenarioForm& form) {
  return form.is_left_alone && form.length >= 10'000'000;
}
bool lies_on_the_floor_and_is_flung(const Core&, const ScenarioForm& form) {
  return form.is_steady && form.has_room && form.is_inside && form.is_still && form.length > 90 &&
         form.start.y_px == form.bounds.bottom_px && has_only<Fling>(form.scenario.events);
}
bool nearly_reaches_the_ceiling(const Core& core, const ScenarioForm& form) {
  return form.is_left_alone && form.has_room && form.is_inside && form.start.vy_px_per_s < 0.0 &&
         std::fabs(form.start.y_px + apex_px(core, form.scenario)) < 20.0;
}
bool is_thrown_into_a_near_corner(const Core&, const ScenarioForm& form) {
  const auto near = [](double at_px, double speed_px_per_s, double far_px) {
    return (speed_px_per_s > 0.0 ? far_px - at_px : at_px) <= 20.0;
  };
  const State& s = form.start;
  return form.is_left_alone && form.has_room && form.is_inside && !form.is_still &&
         std::fabs(s.vx_px_per_s) == std::fabs(s.vy_px_per_s) &&
         near(s.x_px, s.vx_px_per_s, form.bounds.right_px) &&
         near(s.y_px, s.vy_px_per_s, form.bounds.bottom_px);
}
bool is_far_too_fast(const Core&, const ScenarioForm& form) {
  return form.is_left_alone && form.has_room && form.is_inside &&
         std::max(std::fabs(form.start.vx_px_per_s), std::fabs(form.start.vy_px_per_s)) >= 1e5;
}
bool starts_far_outside(const Core&, const ScenarioForm& form) {
  return form.is_left_alone && form.has_room &&
         std::max(std::fabs(form.start.x_px), std::fabs(form.start.y_px)) >= 1e8;
}

struct FamilyOf {
  bool (*fits)(const Core& core, const ScenarioForm& base);
  std::vector<HardCase> (*make)(const Core& core, const Scenario& base);
};

constexpr FamilyOf kFamilies[] = {
    {is_flung_for_minutes, fling_a_minute_family},
    {is_throw_in_long_frames, any_frame_family},
    {is_flung_with_jitter, any_jitter_family},
    {is_far_too_fast, any_speed_family},
    {is_thrown_into_a_near_corner, corners_family},
    {starts_far_outside, far_outside_family},
    {nearly_reaches_the_ceiling, grazing_family},
    {lands_after_hitches, hitch_family},
    {lies_on_the_floor_and_is_flung, on_a_bound_family},
    {is_drop_to_residual_speed, rest_family},
    {is_left_alone_for_days, billion_steps_family},
    {is_trace_with_a_billionth, trace_of_extremes_family},
    {is_drop_to_zero_speed, zeno_family},
};

// Whether the run ends with a sprite that is larger than its window and is not held.
bool is_larger_than_window(const Scenario& scenario) {
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  for (const Event& event : scenario.events) apply(event.action, world);
  return !world.is_held && (world.bounds().right_px < 0.0 || world.bounds().bottom_px < 0.0);
}

// On the floor each frame leaves 0.7992 of vx (drag and friction): 1e12 px/s are subnormal after some 3,400
// frames.
bool slides_to_subnormal_speed(const ScenarioForm& form) {
  return form.is_left_alone && form.has_room && form.is_inside && step_count(form.scenario) >= 3'500 &&
         form.start.y_px == form.bounds.bottom_px && form.start.vy_px_per_s == 0.0 &&
         form.start.vx_px_per_s != 0.0;
}

}  // namespace

std::vector<HardCase> hard_cases_of(const Core& core, const Scenario& scenario) {
  HardCase itself{.name = scenario.name,
                  .made_from = scenario.name,
                  .why = scenario.description.value_or(""),
                  .scenario = scenario,
                  .expected_failures = {}};
  const ScenarioForm form(scenario);
  const char* const never_at_rest = is_larger_than_window(scenario)   ? kNeverStill
                                    : slides_to_subnormal_speed(form) ? kNeverZero
                                                                      : nullptr;
  if (never_at_rest != nullptr) {
    itself.must_come_to_rest = true;
    itself.expected_failures = {{Invariant::comes_to_rest, never_at_rest}};
  }
  itself.is_long = form.length > 1'000'000;
  std::vector<HardCase> cases{std::move(itself)};
  for (const FamilyOf& family : kFamilies)
    if (family.fits(core, form))
      for (HardCase& member : family.make(core, scenario)) cases.push_back(std::move(member));
  return cases;
}

}  // namespace hyrax

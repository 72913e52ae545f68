// Which cases are made from a scenario: itself, and families by what it does, whatever its name.
#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_family.h"

namespace hyrax {
namespace {

constexpr char kNeverZero[] =
    "vx becomes subnormal and stays at 1e-323 px/s, never 0; the position stands still";
constexpr char kNeverStill[] =
    "the sprite is larger than the window: it jumps from wall to wall forever, without any input";

// In the order in which their cases are played.
constexpr MakeFamily* kFamilies[] = {
    fling_a_minute_family, any_frame_family,         any_jitter_family, any_speed_family,  corners_family,
    far_outside_family,    grazing_family,           hitch_family,      on_a_bound_family, rest_family,
    billion_steps_family,  trace_of_extremes_family, zeno_family};

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
                  .scenario = scenario};
  Family family(scenario);
  const ScenarioForm& form = family.form();
  itself.never_at_rest = is_larger_than_window(scenario)   ? kNeverStill
                         : slides_to_subnormal_speed(form) ? kNeverZero
                                                           : "";
  itself.must_come_to_rest = !itself.never_at_rest.empty();
  itself.is_long = form.length > 1'000'000;
  for (MakeFamily* const make : kFamilies) make(core, form, family);
  std::vector<HardCase> cases = family.take();
  cases.insert(cases.begin(), std::move(itself));
  return cases;
}

}  // namespace hyrax

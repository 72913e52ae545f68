// How families of hard cases are built, and which there are.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/core/core.h"
#include "sim/study/hard_cases/hard_case.h"

namespace hyrax {

/// Whether all events are of the kind, and at frames.
template <class Kind>
[[nodiscard]] bool has_only(const std::vector<Event>& events) {
  return std::all_of(events.begin(), events.end(), [](const Event& event) {
    return std::holds_alternative<Kind>(event.action) && std::holds_alternative<std::int64_t>(event.when);
  });
}

/// What families ask of a scenario. Refers to it.
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

/// The members of all families that are made from one scenario.
class Family {
 public:
  explicit Family(const Scenario& base) : base_(base) { base_.expect.reset(); }
  Family(const Family&) = delete;
  Family& operator=(const Family&) = delete;

  /// Of the scenario without `expect`.
  [[nodiscard]] const ScenarioForm& form() const { return form_; }
  HardCase& add(const std::string& what, const std::string& why, const Scenario& scenario) {
    HardCase member{
        .name = base_.name + "/" + what, .made_from = base_.name, .why = why, .scenario = scenario};
    member.scenario.name = base_.name;
    cases_.push_back(std::move(member));
    return cases_.back();
  }
  [[nodiscard]] std::vector<HardCase> take() { return std::move(cases_); }

 private:
  Scenario base_;
  ScenarioForm form_{base_};
  std::vector<HardCase> cases_;
};

/// Adds the members of a family where the scenario is of the form that they are made from.
using MakeFamily = void(const Core& core, const ScenarioForm& form, Family& family);
/// What is varied in the clock and length of a scenario ...
MakeFamily any_frame_family, hitch_family, rest_family, zeno_family, any_jitter_family, fling_a_minute_family,
    trace_of_extremes_family, billion_steps_family;
/// ... and in its places and speeds.
MakeFamily on_a_bound_family, grazing_family, corners_family, any_speed_family, far_outside_family;

}  // namespace hyrax

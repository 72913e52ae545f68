// Families of hard cases: places and speeds.
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/hard_cases/hard_family.h"

namespace hyrax {
namespace {

// The highest point of the start's flight in 600 frames, from a start at 0: at most 0.
double apex_px(const Core& core, const Scenario& scenario) {
  State body{0.0, 0.0, scenario.start_velocity.vx_px_per_s, scenario.start_velocity.vy_px_per_s};
  double apex_px = 0.0;
  for (int frame = 0; frame < 600; ++frame) {
    body = core.flight(body, base_dt_s(scenario.clock));
    apex_px = std::fmin(apex_px, body.y_px);
  }
  return apex_px;
}

}  // namespace

// On each bound, and one double to each side of it, moving away, along and into it.
void on_a_bound_family(const Core&, const ScenarioForm& form, Family& family) {
  if (!(form.is_steady && form.has_room && form.is_inside && form.is_still && form.length > 90 &&
        form.start.y_px == form.bounds.bottom_px && has_only<Fling>(form.scenario.events)))
    return;
  const auto [right_px, bottom_px] = form.bounds;
  struct Bound {
    const char* name;
    bool is_in_x;
    double at_px;
  };
  for (const Bound bound : {Bound{"left", true, 0.0}, Bound{"right", true, right_px},
                            Bound{"top", false, 0.0}, Bound{"ground", false, bottom_px}})
    for (const int ulps : {-1, 0, 1}) {
      Scenario scenario = form.scenario;
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
}

// The apex of a throw at the ceiling: the start height at which the paper's step just reaches it, and doubles
// around it.
void grazing_family(const Core& core, const ScenarioForm& form, Family& family) {
  if (!(form.is_left_alone && form.has_room && form.is_inside && form.start.vy_px_per_s < 0.0)) return;
  const double highest_px = apex_px(core, form.scenario);
  if (!(std::fabs(form.start.y_px + highest_px) < 20.0)) return;
  for (const double off_px : {-1e-3, -1e-9, -1e-13, 0.0, 1e-13, 1e-9, 1e-3}) {
    Scenario scenario = form.scenario;
    scenario.start.y_px = off_px - highest_px;
    family.add(fmt::format("off-{:g}-px", off_px),
               "the ceiling is met with no speed left: a root of even order", scenario);
  }
}

void corners_family(const Core&, const ScenarioForm& form, Family& family) {
  const auto near = [](double at_px, double speed_px_per_s, double far_px) {
    return (speed_px_per_s > 0.0 ? far_px - at_px : at_px) <= 20.0;
  };
  const State& s = form.start;
  if (!(form.is_left_alone && form.has_room && form.is_inside && !form.is_still &&
        std::fabs(s.vx_px_per_s) == std::fabs(s.vy_px_per_s) &&
        near(s.x_px, s.vx_px_per_s, form.bounds.right_px) &&
        near(s.y_px, s.vy_px_per_s, form.bounds.bottom_px)))
    return;
  const auto [right_px, bottom_px] = form.bounds;
  for (const bool is_right : {false, true})
    for (const bool is_low : {false, true})
      for (const char* const where : {"in-it", "an-ulp-from-it", "into-it"}) {
        const auto inside = [where](double corner_px, double other_px) {
          if (where == std::string_view("in-it")) return corner_px;
          if (where == std::string_view("into-it"))
            return corner_px + std::copysign(10.0, other_px - corner_px);
          return std::nextafter(corner_px, other_px);
        };
        Scenario scenario = form.scenario;
        scenario.start = {is_right ? inside(right_px, 0.0) : inside(0.0, right_px),
                          is_low ? inside(bottom_px, 0.0) : inside(0.0, bottom_px)};
        Velocity& velocity = scenario.start_velocity;
        velocity.vx_px_per_s = std::copysign(velocity.vx_px_per_s, is_right ? 1.0 : -1.0);
        velocity.vy_px_per_s = std::copysign(velocity.vy_px_per_s, is_low ? 1.0 : -1.0);
        family.add(std::string(is_low ? "lower" : "upper") + (is_right ? "-right-" : "-left-") + where,
                   "both walls in one frame", scenario);
      }
}

void any_speed_family(const Core&, const ScenarioForm& form, Family& family) {
  if (!(form.is_left_alone && form.has_room && form.is_inside &&
        std::max(std::fabs(form.start.vx_px_per_s), std::fabs(form.start.vy_px_per_s)) >= 1e5))
    return;
  for (const double speed_px_per_s :
       {4.9406564584124654e-324, 1e-310, 1e-300, 1e-150, 1e-9, 1.0, 1e4, 1e6, 1e9, kSpeedMax_px_per_s}) {
    Scenario scenario = form.scenario;
    scenario.start_velocity = {speed_px_per_s, -speed_px_per_s};
    family.add(fmt::format("v-{:g}", speed_px_per_s), "a speed far from that of any throw", scenario);
  }
  constexpr double kFast_px_per_s = 1e4;
  Scenario narrow = form.scenario;
  narrow.window = {narrow.sprite.width_px + 2, narrow.sprite.height_px + 2};
  narrow.start = {1.0, 1.0};
  narrow.start_velocity = {kFast_px_per_s, -kFast_px_per_s};
  family.add("room-of-2-px", "each frame passes the room many times", narrow);
  Scenario wide = form.scenario;
  wide.window = {1'000'000, 1'000'000};
  wide.start = {wide.window.width_px - wide.sprite.width_px - 1.0, 1.0};
  wide.start_velocity = {kFast_px_per_s, -kFast_px_per_s};
  wide.clock.base = FixedRate{1e6};
  family.add("1e6-px-at-1-mhz", "steps so short that a place of a million px rounds what they add", wide);
}

void far_outside_family(const Core&, const ScenarioForm& form, Family& family) {
  if (!(form.is_left_alone && form.has_room &&
        std::max(std::fabs(form.start.x_px), std::fabs(form.start.y_px)) >= 1e8))
    return;
  for (const double away_px : {1e3, 1e9, kCoordinateMax_px})
    for (const int side : {0, 1, 2, 3}) {
      Scenario scenario = form.scenario;
      const double sign = side % 2 == 0 ? -1.0 : 1.0;
      (side < 2 ? scenario.start.x_px : scenario.start.y_px) = sign * away_px;
      constexpr const char* kSides[] = {"left", "right", "above", "below"};
      family.add(fmt::format("{}-{:g}-px", kSides[side], away_px), "a start far outside the window",
                 scenario);
    }
}

}  // namespace hyrax

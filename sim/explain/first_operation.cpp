#include "sim/explain/first_operation.h"

#include "sim/motion/step.h"

namespace hyrax {
namespace {

// What the listing makes of the state: after the flight, and after the walls.
struct ListedStep {
  State flight;
  State after;
  std::uint8_t in_x = 0;
  std::uint8_t in_y = 0;
};

ListedStep listed_step(const Constants& constants, const ObservedStep& observed) {
  const ListingStep step(constants, AllParts{}, observed.bounds);
  ListedStep listed{.flight = observed.before, .after = {}};
  step.fly(listed.flight, observed.dt_s);
  listed.after = listed.flight;
  listed.in_x = step.meet_walls_in_x(listed.after);
  listed.in_y = step.meet_walls_in_y(listed.after);
  return listed;
}

bool is_at(double at_px, double bound_px) { return at_px == 0.0 || at_px == bound_px; }

}  // namespace

std::optional<Operation> first_operation(const Constants& constants, const ObservedStep& observed) {
  const ListedStep listed = listed_step(constants, observed);
  const State& expected = listed.after;
  const State& actual = observed.after;
  const bool same_x = same_bits(expected.x_px, actual.x_px);
  const bool same_y = same_bits(expected.y_px, actual.y_px);
  const bool same_vx = same_bits(expected.vx_px_per_s, actual.vx_px_per_s);
  const bool same_vy = same_bits(expected.vy_px_per_s, actual.vy_px_per_s);
  const bool is_clamped_in_x = listed.in_x != 0;
  const bool is_clamped_in_y = listed.in_y != 0;
  const bool is_on_ground = touches(listed.in_y, Wall::ground);
  // Walls that only the observed step met.
  const bool has_new_wall_x = !is_clamped_in_x && !same_x && is_at(actual.x_px, observed.bounds.right_px);
  const bool has_new_wall_y = !is_clamped_in_y && !same_y && is_at(actual.y_px, observed.bounds.bottom_px);

  if (!is_clamped_in_y && !has_new_wall_y && !same_vy)
    return observed.dt_s == 0.0 ? std::optional(Operation::drag) : std::nullopt;
  if (!is_clamped_in_x && !has_new_wall_x && !is_on_ground && !has_new_wall_y && !same_vx)
    return Operation::drag;
  if (!is_clamped_in_x && !has_new_wall_x && !same_x) return Operation::position;
  if (!is_clamped_in_y && !has_new_wall_y && !same_y) return Operation::position;
  if (has_new_wall_x || !same_x) return Operation::wall_x;
  if (is_clamped_in_x && !is_on_ground && !same_vx) return Operation::restitution;
  if (has_new_wall_y || !same_y) return Operation::wall_y;
  if (!same_vy) {
    const bool one_rests = expected.vy_px_per_s == 0.0 || actual.vy_px_per_s == 0.0;
    return is_on_ground && one_rests ? Operation::rest_rule : Operation::restitution;
  }
  return is_on_ground && !is_clamped_in_x ? std::optional(Operation::friction) : std::nullopt;
}

}  // namespace hyrax

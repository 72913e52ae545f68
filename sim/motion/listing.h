// The paper's listing as data: the base of what is varied. A test compares it with physics::update bit for
// bit.
#pragma once

#include "sim/motion/statement.h"

namespace hyrax {

/// The constant of an operation; nullptr: it has none.
[[nodiscard]] constexpr double Constants::*constant_of(Operation operation) {
  switch (operation) {
    case Operation::gravity:
      return &Constants::gravity_px_per_s2;
    case Operation::drag:
      return &Constants::air_drag;
    case Operation::restitution:
      return &Constants::restitution;
    case Operation::friction:
      return &Constants::ground_friction;
    case Operation::rest_rule:
      return &Constants::rest_threshold_px_per_s;
    case Operation::position:
    case Operation::wall_x:
    case Operation::wall_y:
      return nullptr;
  }
  return nullptr;
}

/// vy += G dt; vx *= drag; vy *= drag; x += vx dt; y += vy dt; walls in x; walls in y, with friction and the
/// rest rule on the ground. Source: the paper's listing, section 6.
[[nodiscard]] inline StepStatements listing(const Constants& constants) {
  using Form = Statement::Form;
  using enum Operation;
  const auto scale = [](Operation operation, Component target, double factor) {
    return Statement{.form = Form::scale, .operation = operation, .target = target, .factor = factor};
  };
  const auto move = [](Component target, Component source) {
    return Statement{.form = Form::move, .operation = position, .target = target, .source = source};
  };
  const auto wall = [&](Operation operation, Component position_of, Component speed, Relation relation,
                        WallPlace place) {
    return Statement{
        .form = Form::wall,
        .operation = operation,
        .source = position_of,
        .relation = relation,
        .place = place,
        .body = {{.form = Form::clamp, .operation = operation, .target = position_of, .place = place},
                 scale(restitution, speed, -constants.restitution)}};
  };
  const auto first_of = [](Operation operation, std::vector<Statement> walls) {
    return Statement{.form = Form::first_of, .operation = operation, .body = std::move(walls)};
  };
  using enum Component;
  Statement ground = wall(wall_y, y, vy, Relation::above, WallPlace::bottom);
  ground.body.push_back(scale(friction, vx, constants.ground_friction));
  ground.body.push_back({.form = Form::stop,
                         .operation = rest_rule,
                         .target = vy,
                         .source = vy,
                         .factor = constants.rest_threshold_px_per_s});
  return {
      {.form = Form::accelerate, .operation = gravity, .target = vy, .factor = constants.gravity_px_per_s2},
      scale(drag, vx, constants.air_drag),
      scale(drag, vy, constants.air_drag),
      move(x, vx),
      move(y, vy),
      first_of(wall_x, {wall(wall_x, x, vx, Relation::below, WallPlace::zero),
                        wall(wall_x, x, vx, Relation::above, WallPlace::right)}),
      first_of(wall_y, {wall(wall_y, y, vy, Relation::below, WallPlace::zero), std::move(ground)})};
}

}  // namespace hyrax

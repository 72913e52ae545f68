// A step as data: a list of statements, which studies put in another order and explain changes one by one.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/motion/state.h"

namespace hyrax {

/// The operation of the listing that a statement belongs to.
enum class Operation : std::uint8_t {
  gravity,
  drag,
  position,
  wall_x,
  wall_y,
  restitution,
  friction,
  rest_rule
};
inline constexpr std::array<std::string_view, 8> kOperationNames = {
    "gravity", "drag", "position", "wall_x", "wall_y", "restitution", "friction", "rest_rule"};
[[nodiscard]] constexpr std::string_view name_of(Operation operation) {
  return kOperationNames[static_cast<std::size_t>(operation)];
}

/// A component of State.
enum class Component : std::uint8_t { x, y, vx, vy };
inline constexpr std::array<Component, 4> kComponents = {Component::x, Component::y, Component::vx,
                                                         Component::vy};
inline constexpr std::array<double State::*, 4> kStateMembers = {&State::x_px, &State::y_px,
                                                                 &State::vx_px_per_s, &State::vy_px_per_s};
[[nodiscard]] inline double& at(State& state, Component which) {
  return state.*kStateMembers[static_cast<std::size_t>(which)];
}

/// Where a wall is: 0, Bounds::right_px, Bounds::bottom_px.
enum class WallPlace : std::uint8_t { zero, right, bottom };

/// How a condition compares.
enum class Relation : std::uint8_t { below, at_most, above, at_least };
[[nodiscard]] constexpr bool holds(Relation relation, double a, double b) {
  switch (relation) {
    case Relation::below:
      return a < b;
    case Relation::at_most:
      return a <= b;
    case Relation::above:
      return a > b;
    case Relation::at_least:
      return a >= b;
  }
  return false;
}

/// One statement of a step. Of its members only those that its form names have a meaning.
struct Statement {
  enum class Form : std::uint8_t {
    accelerate,  ///< target += factor * dt.
    move,        ///< target += source * dt, subtracted if factor < 0.
    scale,     ///< target *= factor; restitution has factor = -RESTITUTION, whose product has the same bits.
    clamp,     ///< target = place.
    stop,      ///< if (|source| relation factor) target = 0; source itself if it is `signed_source`.
    wall,      ///< if (source relation place) body.
    first_of,  ///< The first wall of `body` whose condition holds: if, else if.
  };
  Form form = Form::scale;
  Operation operation = Operation::drag;
  Component target = Component::x;
  Component source = Component::x;
  double factor = 1.0;
  bool is_fused = false;  ///< One rounding for product and sum (std::fma).
  bool signed_source = false;
  Relation relation = Relation::below;
  WallPlace place = WallPlace::zero;
  std::vector<Statement> body = {};
};

/// A whole step: statements that run in order.
using StepStatements = std::vector<Statement>;

/// a * b, rounded before anything is added to it, even in a build that fuses multiply-adds.
[[nodiscard]] inline double rounded_product(double a, double b) {
  const volatile double product = a * b;
  return product;
}

/// A step as data, on one body within its bounds.
class StatementRun {
 public:
  StatementRun(double dt_s, const Bounds& bounds)
      : dt_s_(dt_s), places_px_{0.0, bounds.right_px, bounds.bottom_px} {}

  /// Runs the statements in order.
  void operator()(const StepStatements& statements, State& state) const {
    for (const Statement& statement : statements) run(statement, state);
  }

 private:
  void run(const Statement& s, State& state) const {
    double& target = at(state, s.target);
    switch (s.form) {
      case Statement::Form::accelerate:
        return add_product(target, s.factor, s.is_fused);
      case Statement::Form::move:
        return add_product(target, s.factor < 0.0 ? -at(state, s.source) : at(state, s.source), s.is_fused);
      case Statement::Form::scale:
        target *= s.factor;
        return;
      case Statement::Form::clamp:
        target = place_px(s);
        return;
      case Statement::Form::stop: {
        const double source = at(state, s.source);
        if (holds(s.relation, s.signed_source ? source : std::fabs(source), s.factor)) target = 0.0;
        return;
      }
      case Statement::Form::wall:
        static_cast<void>(meets(s, state));
        return;
      case Statement::Form::first_of:
        for (const Statement& wall : s.body)
          if (meets(wall, state)) return;
        return;
    }
  }
  bool meets(const Statement& wall, State& state) const {
    if (!holds(wall.relation, at(state, wall.source), place_px(wall))) return false;
    (*this)(wall.body, state);
    return true;
  }
  void add_product(double& target, double factor, bool is_fused) const {
    target = is_fused ? std::fma(factor, dt_s_, target) : target + rounded_product(factor, dt_s_);
  }
  [[nodiscard]] double place_px(const Statement& s) const {
    return places_px_[static_cast<std::size_t>(s.place)];
  }

  double dt_s_;
  std::array<double, 3> places_px_;
};

}  // namespace hyrax

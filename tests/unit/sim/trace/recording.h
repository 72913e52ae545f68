// A small recording number, so that tests write steps as C++: each function is called once a path.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "sim/physics/physics.h"
#include "sim/trace/operations.h"
#include "sim/trace/step_text.h"

namespace hyrax::recording {

/// The step being recorded, and the outcomes that the present call shall have.
struct Recorder {
  TracedStep step;
  std::vector<StepOutcome> path;
  std::vector<bool> plan;
  static Recorder& now() {
    static Recorder recorder;
    return recorder;
  }

  std::int32_t add(const Expression& expression) {
    for (std::size_t index = 0; index < step.expressions.size(); ++index)
      if (step.expressions[index] == expression) return static_cast<std::int32_t>(index);
    step.expressions.push_back(expression);
    return static_cast<std::int32_t>(step.expressions.size() - 1);
  }
  bool decide(const StepComparison& comparison) {
    const Expression& left = step.expressions[static_cast<std::size_t>(comparison.left)];
    const Expression& right = step.expressions[static_cast<std::size_t>(comparison.right)];
    if (left.op == Operator::constant && right.op == Operator::constant)
      return holds(comparison.relation, left.value, right.value);
    std::size_t index = 0;
    while (index < step.comparisons.size() && !(step.comparisons[index] == comparison)) ++index;
    if (index == step.comparisons.size()) step.comparisons.push_back(comparison);
    for (const StepOutcome& outcome : path)
      if (outcome.comparison == static_cast<std::int32_t>(index)) return outcome.holds;
    const bool holds = path.size() < plan.size() && plan[path.size()];
    path.push_back({static_cast<std::int32_t>(index), holds});
    return holds;
  }
};

template <NumberKind kKind>
struct Number {
  std::int32_t id = -1;
  Number() = default;
  Number(double value)  // NOLINT: converts as a number does.
      : id(Recorder::now().add({.op = Operator::constant, .kind = kKind, .value = value})) {}
  static Number of(Operator op, std::array<std::int32_t, 3> operands, const std::string& name = {}) {
    Number number;
    number.id = Recorder::now().add({.op = op, .kind = kKind, .operands = operands, .name = name});
    return number;
  }
  static Number argument(const std::string& name) { return of(Operator::argument, {-1, -1, -1}, name); }

  friend Number operator-(Number a) { return of(Operator::negate, {a.id, -1, -1}); }
  friend Number operator+(Number a, Number b) { return of(Operator::add, {a.id, b.id, -1}); }
  friend Number operator-(Number a, Number b) { return a + -b; }
  friend Number operator*(Number a, Number b) { return of(Operator::multiply, {a.id, b.id, -1}); }
  friend Number operator/(Number a, Number b) { return of(Operator::divide, {a.id, b.id, -1}); }
  friend Number operator%(Number a, Number b) { return of(Operator::remainder, {a.id, b.id, -1}); }
  friend bool operator<(Number a, Number b) { return Recorder::now().decide({Relation::less, a.id, b.id}); }
  friend bool operator<=(Number a, Number b) {
    return Recorder::now().decide({Relation::less_or_equal, a.id, b.id});
  }
  friend bool operator>(Number a, Number b) { return b < a; }
  friend bool operator>=(Number a, Number b) { return b <= a; }
  friend bool operator==(Number a, Number b) { return Recorder::now().decide({Relation::equal, a.id, b.id}); }
};
using Real = Number<NumberKind::real>;
using Single = Number<NumberKind::single>;
using Whole = Number<NumberKind::whole>;

inline Real to_real(Whole a) { return Real::of(Operator::to_real, {a.id, -1, -1}); }
inline Real to_real(Single a) { return Real::of(Operator::to_real, {a.id, -1, -1}); }
inline Single to_single(Real a) { return Single::of(Operator::to_single, {a.id, -1, -1}); }
inline Whole to_whole(Real a) { return Whole::of(Operator::to_whole, {a.id, -1, -1}); }
inline Real fabs(Real a) { return Real::of(Operator::call, {a.id, -1, -1}, "fabs"); }
inline Real sqrt(Real a) { return Real::of(Operator::call, {a.id, -1, -1}, "sqrt"); }
inline Real pow(Real a, Real b) { return Real::of(Operator::call, {a.id, b.id, -1}, "pow"); }
inline Real fma(Real a, Real b, Real c) { return Real::of(Operator::call, {a.id, b.id, c.id}, "fma"); }

/// A body and what a frame gives it.
struct Body {
  Real x = Real::argument("x"), y = Real::argument("y"), vx = Real::argument("vx"), vy = Real::argument("vy");
};
struct Frame {
  Real dt = Real::argument("dt");
  Whole window_width = Whole::argument("window_width"), window_height = Whole::argument("window_height"),
        sprite_width = Whole::argument("sprite_width"), sprite_height = Whole::argument("sprite_height");
};

using Update = std::function<void(Body&, const Frame&)>;

/// Records `update`, with the paper's constructor and setters.
inline TracedStep record(const Update& update) {
  Recorder& recorder = Recorder::now();
  recorder.step = {.members = std::vector<NumberKind>(4, NumberKind::real)};
  const auto members = [](const Body& body) {
    return std::vector<std::int32_t>{body.x.id, body.y.id, body.vx.id, body.vy.id};
  };
  const auto once = [&](CoreFunction function, const std::function<void(Body&)>& call) {
    Body body;
    call(body);
    recorder.step.paths[static_cast<std::size_t>(function)].push_back({recorder.path, members(body)});
  };
  recorder.path.clear();
  once(CoreFunction::construct, [](Body& body) {
    body = {Real::argument("start_x"), Real::argument("start_y"), Real::argument("start_vx"),
            Real::argument("start_vy")};
  });
  once(CoreFunction::set_position, [](Body& body) {
    body.x = Real::argument("new_x");
    body.y = Real::argument("new_y");
  });
  once(CoreFunction::set_velocity, [](Body& body) {
    body.vx = Real::argument("new_vx");
    body.vy = Real::argument("new_vy");
  });
  once(CoreFunction::reset_velocity, [](Body& body) { body.vx = body.vy = Real(0.0); });
  std::vector<std::vector<bool>> plans = {{}};
  while (!plans.empty()) {
    recorder.plan = plans.back();
    plans.pop_back();
    recorder.path.clear();
    once(CoreFunction::update, [&](Body& body) { update(body, Frame()); });
    for (std::size_t turn = recorder.plan.size(); turn < recorder.path.size(); ++turn) {
      std::vector<bool>& plan = plans.emplace_back();
      for (std::size_t before = 0; before < turn; ++before) plan.push_back(recorder.path[before].holds);
      plan.push_back(true);
    }
  }
  return recorder.step;
}

/// The listing, with places at which a test changes it.
struct Listing {
  Real gravity = physics::GRAVITY, restitution = physics::RESTITUTION, drag = physics::AIR_DRAG,
       friction = physics::GROUND_FRICTION, threshold = physics::REST_THRESHOLD;
  std::function<void(Body&, const Frame&)> before_drag, before_move, before_walls, at_end;
  std::function<bool(const Body&, const Frame&)> extra_right, extra_ground;

  void operator()(Body& body, const Frame& frame) const {
    body.vy = body.vy + gravity * frame.dt;
    if (before_drag) before_drag(body, frame);
    body.vx = body.vx * drag;
    body.vy = body.vy * drag;
    if (before_move) before_move(body, frame);
    body.x = body.x + body.vx * frame.dt;
    body.y = body.y + body.vy * frame.dt;
    if (before_walls) before_walls(body, frame);
    const Real right = to_real(frame.window_width - frame.sprite_width);
    const Real bottom = to_real(frame.window_height - frame.sprite_height);
    if (body.x < 0.0) {
      body.x = 0.0;
      body.vx = -body.vx * restitution;
    } else if (body.x > right && (!extra_right || extra_right(body, frame))) {
      body.x = right;
      body.vx = -body.vx * restitution;
    }
    if (body.y < 0.0) {
      body.y = 0.0;
      body.vy = -body.vy * restitution;
    } else if (body.y > bottom) {
      body.y = bottom;
      body.vy = -body.vy * restitution;
      body.vx = body.vx * friction;
      if (fabs(body.vy) < threshold && (!extra_ground || extra_ground(body, frame))) body.vy = 0.0;
    }
    if (at_end) at_end(body, frame);
  }
};

/// The listing of the paper. Recorded in a call, so that its constants are of the same recording.
inline TracedStep record_listing() {
  return record([](Body& body, const Frame& frame) { Listing()(body, frame); });
}

}  // namespace hyrax::recording

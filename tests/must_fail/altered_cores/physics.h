// The core of the altered program: class physics, its step altered as HYRAX_ALTERED_CORE says.
#pragma once

#include <cmath>

#include "sim/physics/strict_arithmetic.h"
#include "tests/must_fail/altered_cores/altered_core.h"

class physics {
 public:
  static inline const double GRAVITY = hyrax::altered_step().gravity;
  static inline const double RESTITUTION = hyrax::altered_step().restitution;
  static inline const double AIR_DRAG = hyrax::altered_step().air_drag;
  static inline const double GROUND_FRICTION = hyrax::altered_step().ground_friction;
  static inline const double REST_THRESHOLD = hyrax::altered_step().rest_threshold;

  physics() : physics(0.0, 0.0) {}
  physics(double x, double y, double vx = 0.0, double vy = 0.0) : body_{x, y, vx, vy} {}

  void update(double dt, int screenW, int screenH, int objW, int objH) {
    hyrax::update(body_, dt, screenW, screenH, objW, objH);
  }

  double x() const { return body_.x; }
  double y() const { return body_.y; }
  double vx() const { return body_.vx; }
  double vy() const { return body_.vy; }

  void setPos(double x, double y) { hyrax::set(body_.x, body_.y, hyrax::altered_step().set_pos, x, y); }
  void setVelocity(double vx, double vy) {
    hyrax::set(body_.vx, body_.vy, hyrax::altered_step().set_velocity, vx, vy);
  }
  void resetVelocity() { hyrax::set(body_.vx, body_.vy, hyrax::altered_step().reset_velocity, 0.0, 0.0); }

 private:
  hyrax::AlteredBody body_;
};

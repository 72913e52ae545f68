// The shipped core: the hyrax's body and its one step, as the paper's listing has it.
//
// Source: "Use of physics in hyrax.exe", section 6. Names, signatures, constants and the order of
// operations are the paper's; where its words and its listing differ, the listing holds.
// It is in a header so that a hot loop keeps the state in registers: called out of line, the
// state goes through memory at every step.
#pragma once

#include <cmath>

#include "sim/physics/strict_arithmetic.h"

/// A body in a window. Origin top left, +x right, +y down; px, px/s, s.
class physics {
 public:
  static constexpr double GRAVITY = 1200.0;       ///< px/s^2, downwards.
  static constexpr double RESTITUTION = 0.6;      ///< [-], ratio of speeds after and before a bounce.
  static constexpr double AIR_DRAG = 0.999;       ///< [-], velocity factor of a step.
  static constexpr double GROUND_FRICTION = 0.8;  ///< [-], horizontal velocity factor of a ground contact.
  static constexpr double REST_THRESHOLD = 5.0;   ///< px/s, below which a ground contact stops vy.

  physics() : physics(0.0, 0.0) {}
  physics(double x, double y, double vx = 0.0, double vy = 0.0) : m_x(x), m_y(y), m_vx(vx), m_vy(vy) {}

  /// One frame of `dt` seconds: gravity, drag, position, then collision in x and in y.
  /// The top left corner is kept within 0 .. screen - obj (sizes in px).
  void update(double dt, int screenWidth, int screenHeight, int objWidth, int objHeight) {
    m_vy += GRAVITY * dt;
    m_vx *= AIR_DRAG;
    m_vy *= AIR_DRAG;

    m_x += m_vx * dt;
    m_y += m_vy * dt;

    const double rightBound = static_cast<double>(screenWidth - objWidth);
    const double bottomBound = static_cast<double>(screenHeight - objHeight);

    if (m_x < 0.0) {
      m_x = 0.0;
      m_vx = -m_vx * RESTITUTION;
    } else if (m_x > rightBound) {
      m_x = rightBound;
      m_vx = -m_vx * RESTITUTION;
    }

    if (m_y < 0.0) {
      m_y = 0.0;
      m_vy = -m_vy * RESTITUTION;
    } else if (m_y > bottomBound) {
      m_y = bottomBound;
      m_vy = -m_vy * RESTITUTION;
      m_vx *= GROUND_FRICTION;
      if (std::fabs(m_vy) < REST_THRESHOLD) m_vy = 0.0;
    }
  }

  double x() const { return m_x; }
  double y() const { return m_y; }
  double vx() const { return m_vx; }
  double vy() const { return m_vy; }

  void setPos(double x, double y) {
    m_x = x;
    m_y = y;
  }
  void setVelocity(double vx, double vy) {
    m_vx = vx;
    m_vy = vy;
  }
  void resetVelocity() { m_vx = m_vy = 0.0; }

 private:
  double m_x, m_y;
  double m_vx, m_vy;
};

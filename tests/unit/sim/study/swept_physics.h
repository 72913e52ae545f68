// The class physics whose update sim/physics/README.md shows: exact flight, and a swept clamp.
#pragma once

#include <algorithm>
#include <cmath>

class SweptPhysics {
 public:
  static constexpr double GRAVITY = 1200.0, RESTITUTION = 0.6, GROUND_FRICTION = 0.8, REST_THRESHOLD = 5.0;

  SweptPhysics(double x, double y, double vx, double vy) : m_x(x), m_y(y), m_vx(vx), m_vy(vy) {}

  void update(double dt, int screenWidth, int screenHeight, int objWidth, int objHeight) {
    const double right = screenWidth - objWidth, bottom = screenHeight - objHeight;
    m_lies = m_lies && m_y == bottom;
    for (int meetings = 0; dt > 0.0 && meetings < 8; ++meetings) {
      const SweptPhysics end = flown(dt);
      const double x = std::clamp(end.m_x, 0.0, right), y = std::clamp(end.m_y, 0.0, bottom);
      const double in_x = x == end.m_x ? 1.0 : std::clamp((x - m_x) / (end.m_x - m_x), 0.0, 1.0);
      const double in_y = y == end.m_y ? 1.0 : std::clamp((y - m_y) / (end.m_y - m_y), 0.0, 1.0);
      const double part = std::min(in_x, in_y);  // Of the way, until the first wall.
      *this = flown(part * dt);
      dt -= part * dt;
      if (in_x == part && x != end.m_x) turn(m_x, x, m_vx);
      if (in_y == part && y != end.m_y) turn(m_y, y, m_vy);
      if (in_y > part || end.m_y <= bottom) continue;
      m_vx *= GROUND_FRICTION;
      m_lies = std::fabs(m_vy) < REST_THRESHOLD;
      if (m_lies) m_vy = 0.0;
    }
  }

  [[nodiscard]] double x() const { return m_x; }
  [[nodiscard]] double y() const { return m_y; }
  [[nodiscard]] double vx() const { return m_vx; }
  [[nodiscard]] double vy() const { return m_vy; }
  void setPos(double x, double y) {
    m_lies = m_lies && y == m_y;
    m_x = x, m_y = y;
  }
  void setVelocity(double vx, double vy) {
    m_lies = m_lies && vy == 0.0;
    m_vx = vx, m_vy = vy;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }

 private:
  static void turn(double& position, double wall, double& speed) {
    position = wall;
    speed *= -RESTITUTION;
  }
  // After a time without walls: v' = G - k v, solved. On the floor without G, and with the friction in k.
  [[nodiscard]] SweptPhysics flown(double t) const {
    const double g = m_lies ? 0.0 : GRAVITY, k = m_lies ? 0.0600300200 + 13.3886131 : 0.0600300200;
    const double z = k * t, two = (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6 * (1 - z / 7))))) / 2;
    const double one = 1 - z * two;
    SweptPhysics to = *this;
    to.m_x += m_vx * t * one;
    to.m_y += (m_vy * one + g * t * two) * t;
    to.m_vx -= m_vx * z * one;
    to.m_vy += (g * t - m_vy * z) * one;
    return to;
  }

  double m_x, m_y;
  double m_vx, m_vy;
  bool m_lies = false;  // On the floor, after the last bounce.
};

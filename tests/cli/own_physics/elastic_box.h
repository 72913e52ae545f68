// Another world: no gravity, no drag, and walls that reflect the sprite without loss.
#pragma once

class physics {
 public:
  static constexpr double RESTITUTION = 1.0;  // [-], ratio of speeds after and before a bounce.

  physics(double x, double y, double vx, double vy) : m_x(x), m_y(y), m_vx(vx), m_vy(vy) {}

  void update(double dt, int screenWidth, int screenHeight, int objWidth, int objHeight) {
    m_x += m_vx * dt;
    m_y += m_vy * dt;
    reflect(m_x, m_vx, screenWidth - objWidth);
    reflect(m_y, m_vy, screenHeight - objHeight);
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
  static void reflect(double& position, double& velocity, double bound) {
    if (position >= 0.0 && position <= bound) return;
    position = (position < 0.0 ? 0.0 : 2.0 * bound) - position;
    velocity = -velocity * RESTITUTION;
  }

  double m_x, m_y;
  double m_vx, m_vy;
};

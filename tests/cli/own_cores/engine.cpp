#include "engine.h"

namespace engine {

void game::tick(double dt) {
  m_speed -= m_x * dt;
  m_x += m_speed * dt;
}
double& game::x() { return m_x; }
double& game::speed() { return m_speed; }

}  // namespace engine

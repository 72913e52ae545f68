// A game whose functions are in a library.
#pragma once

namespace engine {

class game {
 public:
  void tick(double dt);
  double& x();
  double& speed();

 private:
  double m_x = 1, m_speed = 2;
};

}  // namespace engine

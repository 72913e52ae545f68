// A generator that cannot be declared, and says so.
#pragma once

#include <random>

struct hyrax_core {
  double x = 0;
  std::mt19937 generator{7};

  void step(double dt_s) { x += dt_s * static_cast<double>(generator() % 100U); }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see.undeclared("generator");
  }
};

// A core of a library's class, with a function that is defined outside its class and not inline.
#pragma once

#include "engine.h"

struct oscillator {
  engine::game game;
  void step(double dt_s);
  void state(auto&& see) {
    see("x_m", game.x());
    see("speed_m_per_s", game.speed());
  }
};
void oscillator::step(double dt_s) { game.tick(dt_s); }

using hyrax_core = oscillator;

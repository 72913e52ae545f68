// The yardstick of speed: physics::update out of line, one call a step, state in memory.
#pragma once

#include "sim/physics/physics.h"

namespace hyrax::bench {

void naive_step(physics& body, double dt, int screen_width, int screen_height, int obj_width, int obj_height);

}  // namespace hyrax::bench

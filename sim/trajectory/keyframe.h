// All that a replay needs to go on from a row.
#pragma once

#include "sim/scenario/scenario.h"
#include "sim/scenario/timeline.h"
#include "sim/trajectory/row.h"

namespace hyrax {

/// The state after a frame: the row, the time as the time rule holds it, the sizes in force and
/// whether the sprite is held. What comes next follows from the scenario and the row's number.
struct Keyframe {
  Row row;
  Timeline timeline;
  Size window;
  Size sprite;
  bool is_held = false;
};

}  // namespace hyrax

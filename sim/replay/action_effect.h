// What an action does to the state before the frame it falls on.
#pragma once

#include "sim/scenario/scenario.h"
#include "sim/trajectory/keyframe.h"

namespace hyrax {

/// Applies an action at once. A hitch changes no state: it is the dt of its frame.
void apply(const Action& action, Keyframe& state);

}  // namespace hyrax

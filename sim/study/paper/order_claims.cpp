// Sections 2.4, 4.3 and 6: the order of operations.
#include <algorithm>

#include "sim/core/core.h"
#include "sim/motion/step.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

// The largest distance, over the frames of a second, between a throw at a wall in the paper's order and in
// another. Walls first is the same cycle of operations from another start: it differs only at a wall.
double largest_distance_px(const Core& core, StepOrder order) {
  const Constants constants = core.constants.value();
  double worst_px = 0.0;
  State paper{100.0, 500.0, 2400.0, -700.0}, other = paper;
  for (int step = 0; step < 60; ++step) {
    paper = stepped(constants, StepOrder::paper, paper, kSixtieth_s, kDesktop);
    other = stepped(constants, order, other, kSixtieth_s, kDesktop);
    worst_px = std::max(worst_px, std::hypot(paper.x_px - other.x_px, paper.y_px - other.y_px));
  }
  return worst_px;
}

Finding order_alters(const Core& core) {
  if (steps_that_differ_from_listing(core, 5000) > 0) return {.remark = kOrderOfOther};
  const double drag_first = largest_distance_px(core, StepOrder::drag_first),
               position_first = largest_distance_px(core, StepOrder::position_first),
               walls_first = largest_distance_px(core, StepOrder::walls_first);
  const double least = std::min({drag_first, position_first, walls_first});
  return {least, holds_if(least > 0.0),
          "drag first " + digits(drag_first) + ", position first " + digits(position_first) +
              ", walls first " + digits(walls_first) + " px"};
}

Finding damped_gain(const Core& core) {
  const double undamped = core.constants->gravity_px_per_s2 * kSixtieth_s;
  if (undamped == 0.0) return {.remark = kNoGravity};
  const double part = core.flight({}, kSixtieth_s).vy_px_per_s / undamped;
  return {part, holds_if(part < 1.0)};
}

// Rows in which a fling is outside the window, with collisions resolved last, as in the core, or first.
Finding after_position(const Core& core) {
  const Constants constants = core.constants.value();
  std::int64_t outside = 0, outside_walls_first = 0;
  State core_body{300.0, 500.0, 3000.0, -2000.0}, other = core_body;
  for (int step = 0; step < 2000; ++step) {
    core_body = core.step(core_body, kSixtieth_s, kDesktop);
    other = stepped(constants, StepOrder::walls_first, other, kSixtieth_s, kDesktop);
    outside += is_on_desktop(core_body) ? 0 : 1;
    outside_walls_first += is_on_desktop(other) ? 0 : 1;
  }
  return {static_cast<double>(outside), holds_if(outside == 0 && outside_walls_first > 0),
          "with collisions first there are " + std::to_string(outside_walls_first)};
}

}  // namespace

std::vector<Claim> order_claims(const Core& core) {
  const std::int64_t differing = steps_that_differ_from_listing(core, 20'000);
  return {
      {{"4.3-damps-gain", "applying gravity before drag allows the drag to damp the newly gained speed",
        "speed gained in a step from rest, as a part of G dt", "< 1"},
       damped_gain(core)},
      {{"4.3-not-stuck",
        "collisions are resolved after the position update to prevent objects from getting stuck inside "
        "boundaries",
        "frames of 2000 in which a throw was past a bound", "0"},
       after_position(core)},
      {{"4.3-order-alters", "changing the order would alter the effective dynamics",
        "least of the largest shifts, in a second of a throw, by three other orders", "> 0", "px"},
       order_alters(core)},
      {{"6-exactly",
        "the update method implements exactly the steps described: gravity, drag, position, collisions",
        "steps of 40 random flings that differ in a bit from the listing's with the core's constants", "0"},
       {static_cast<double>(differing), holds_if(differing == 0)}}};
}

}  // namespace hyrax

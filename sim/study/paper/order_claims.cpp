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

Claim order_alters(const Core& core) {
  const bool is_listing = steps_that_differ_from_listing(core, 5000) == 0;
  const double drag_first = largest_distance_px(core, StepOrder::drag_first),
               position_first = largest_distance_px(core, StepOrder::position_first),
               walls_first = largest_distance_px(core, StepOrder::walls_first);
  const double least = std::min({drag_first, position_first, walls_first});
  return {"4.3-order-alters",
          "changing the order would alter the effective dynamics",
          "least of the largest shifts, in a second of a throw, by three other orders",
          "> 0",
          is_listing ? least : kNotGiven,
          "px",
          is_listing ? holds_if(least > 0.0) : ClaimVerdict::not_measured,
          !is_listing ? "this core's step is not the listing's, whose order could be changed"
                      : "drag first " + digits(drag_first) + ", position first " + digits(position_first) +
                            ", walls first " + digits(walls_first) + " px"};
}

// Rows in which a fling is outside the window, with collisions resolved last, as in the core, or first.
Claim after_position(const Core& core) {
  const Constants constants = core.constants.value();
  std::int64_t outside = 0, outside_walls_first = 0;
  const auto is_outside = [](const State& body) {
    return body.x_px < 0.0 || body.x_px > kDesktop.right_px || body.y_px < 0.0 ||
           body.y_px > kDesktop.bottom_px;
  };
  State core_body{300.0, 500.0, 3000.0, -2000.0}, other = core_body;
  for (int step = 0; step < 2000; ++step) {
    core_body = core.step(core_body, kSixtieth_s, kDesktop);
    other = stepped(constants, StepOrder::walls_first, other, kSixtieth_s, kDesktop);
    outside += is_outside(core_body) ? 1 : 0;
    outside_walls_first += is_outside(other) ? 1 : 0;
  }
  return {"4.3-not-stuck",
          "collisions are resolved after the position update to prevent objects from getting stuck inside "
          "boundaries",
          "frames of 2000 in which a throw was past a bound",
          "0",
          static_cast<double>(outside),
          "1",
          holds_if(outside == 0 && outside_walls_first > 0),
          "with collisions first there are " + std::to_string(outside_walls_first)};
}

}  // namespace

std::vector<Claim> order_claims(const Core& core) {
  const double gained = core.flight({}, kSixtieth_s).vy_px_per_s;
  const double undamped = core.constants->gravity_px_per_s2 * kSixtieth_s;
  const std::int64_t differing = steps_that_differ_from_listing(core, 20'000);
  return {{"4.3-damps-gain", "applying gravity before drag allows the drag to damp the newly gained speed",
           "speed gained in a step from rest, as a part of G dt", "< 1",
           undamped != 0.0 ? gained / undamped : kNotGiven, "1",
           undamped != 0.0 ? holds_if(gained / undamped < 1.0) : ClaimVerdict::not_measured,
           undamped != 0.0 ? "" : kNoGravity},
          after_position(core),
          order_alters(core),
          {"6-exactly",
           "the update method implements exactly the steps described: gravity, drag, position, collisions",
           "steps of 40 random flings that differ in a bit from the listing's with the core's constants", "0",
           static_cast<double>(differing), "1", holds_if(differing == 0)}};
}

}  // namespace hyrax

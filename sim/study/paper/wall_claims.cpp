// Section 3: bounds, walls, restitution, friction.
#include <algorithm>
#include <cmath>

#include "sim/core/core.h"
#include "sim/motion/step.h"
#include "sim/study/paper/claim_probe.h"

namespace hyrax {
namespace {

// What 200 throws did at the walls.
struct Reach {
  Extremes x_px, y_px;
  double clamp_error_px = 0.0;  ///< Largest distance of a clamped position from its bound.
  Extremes ratio;               ///< Of normal speeds after and before, at the side walls.
  double vy_change_at_walls_px_per_s = 0.0;
  Extremes friction;  ///< vx after over vx before, on the ground.
  double vx_change_in_flight = 0.0;
  double slowest_bounce_px_per_s = HUGE_VAL;  ///< Smallest |vy| after a ground contact, except 0.
  double energy_ratio = 0.0;                  ///< Of the last bounce off a side wall.
  std::int64_t side_contacts = 0;
  std::int64_t side_bounces = 0;  ///< Those at no other wall: their speeds are compared.
  std::int64_t ground_contacts = 0;
  std::int64_t slides = 0;  ///< Ground contacts whose vx is compared.
};

void include_side_contact(const State& flight, const State& after, bool is_on_ground, Reach& reach) {
  ++reach.side_contacts;
  const double bound_px = flight.x_px < 0.0 ? 0.0 : kDesktop.right_px;
  reach.clamp_error_px = std::max(reach.clamp_error_px, std::fabs(after.x_px - bound_px));
  if (is_on_ground || flight.y_px < 0.0) return;
  ++reach.side_bounces;
  const double ratio = -after.vx_px_per_s / flight.vx_px_per_s;
  reach.ratio.include(ratio);
  reach.energy_ratio = ratio * ratio;
  reach.vy_change_at_walls_px_per_s =
      std::max(reach.vy_change_at_walls_px_per_s, std::fabs(after.vy_px_per_s - flight.vy_px_per_s));
}

void include_step(const State& flight, const State& after, Reach& reach) {
  reach.x_px.include(after.x_px);
  reach.y_px.include(after.y_px);
  const bool is_side = flight.x_px < 0.0 || flight.x_px > kDesktop.right_px;
  const bool is_ground = flight.y_px > kDesktop.bottom_px;
  if (is_side) include_side_contact(flight, after, is_ground, reach);
  if (flight.y_px < 0.0) reach.clamp_error_px = std::max(reach.clamp_error_px, std::fabs(after.y_px));
  if (is_ground) {
    ++reach.ground_contacts;
    reach.clamp_error_px = std::max(reach.clamp_error_px, std::fabs(after.y_px - kDesktop.bottom_px));
    if (after.vy_px_per_s != 0.0)
      reach.slowest_bounce_px_per_s = std::min(reach.slowest_bounce_px_per_s, std::fabs(after.vy_px_per_s));
  }
  if (is_side || flight.vx_px_per_s == 0.0) return;
  const double factor = after.vx_px_per_s / flight.vx_px_per_s;
  if (!is_ground) {
    reach.vx_change_in_flight = std::max(reach.vx_change_in_flight, std::fabs(factor - 1.0));
  } else if (std::fabs(flight.vx_px_per_s) > 1e-200) {
    ++reach.slides;
    reach.friction.include(factor);
  }
}

// Random throws across the desktop, step by step.
Reach reach_of_throws(const Core& core) {
  Reach reach;
  for (std::uint64_t fling = 0; fling < 200; ++fling) {
    State body = random_throw({.seed = 2, .fastest_px_per_s = 4000.0}, fling);
    for (int step = 0; step < 200; ++step) {
      const State flight = core.flight(body, kSixtieth_s);
      body = core.step(body, kSixtieth_s, kDesktop);
      include_step(flight, body, reach);
    }
  }
  return reach;
}

// A claim on walls that no throw met is not measured, and has neither number nor remark.
Finding if_met(std::int64_t contacts, const Finding& finding) { return contacts > 0 ? finding : Finding(); }

Finding ceiling(const Core& core) {
  const State after = core.step({500.0, 10.0, 0.0, -1000.0}, 0.05, kDesktop);
  const State met = core.flight({500.0, 10.0, 0.0, -1000.0}, 0.05);
  const double ratio = after.vy_px_per_s / met.vy_px_per_s;
  return {ratio, holds_if(after.y_px == 0.0 && ratio < 0.0 && is_close(-ratio, core.constants->restitution))};
}

// Which comparison agrees with the bounces.
std::string slowest_bounce_text(const Core& core, const Reach& reach) {
  if (std::isinf(reach.slowest_bounce_px_per_s)) return "";  // None bounced.
  const bool keeps_threshold = reach.slowest_bounce_px_per_s >= core.constants->rest_threshold_px_per_s;
  return std::string(keeps_threshold ? "it is |vy| that is compared" : "|vy| is not compared, either") +
         ": the slowest bounce seen left " + digits(reach.slowest_bounce_px_per_s) + " px/s";
}

// Read literally, every bounce would be stopped: it goes up, so vy < 0 < threshold.
Finding threshold_in_words(const Core& core, const Reach& reach) {
  const State from{500.0, 950.0, 0.0, 800.0};
  const State bounced = core.step(from, kSixtieth_s, kDesktop);
  return {bounced.vy_px_per_s, holds_if(bounced.vy_px_per_s == 0.0),
          bounced.vy_px_per_s == 0.0 ? "" : slowest_bounce_text(core, reach)};
}

// Into corners, both walls in one step, by both orders of the listing's walls.
struct CornerOrders {
  double outside_px = -HUGE_VAL;  ///< Largest distance outside the window after either order.
  double difference = 0.0;        ///< Largest relative difference of speeds between the two.
};
CornerOrders corner_orders(const Core& core) {
  CornerOrders orders;
  const Constants constants = core.constants.value();
  for (std::uint64_t draw = 0; draw < 1000; ++draw) {
    const State body{kDesktop.right_px - random_between(3, 4 * draw, 0.0, 20.0),
                     kDesktop.bottom_px - random_between(3, 4 * draw + 1, 0.0, 20.0),
                     random_between(3, 4 * draw + 2, 1500.0, 9000.0),
                     random_between(3, 4 * draw + 3, 1500.0, 9000.0)};
    const State x_first = stepped(constants, StepOrder::paper, body, kSixtieth_s, kDesktop);
    const State y_first = stepped(constants, StepOrder::y_walls_first, body, kSixtieth_s, kDesktop);
    for (const State& after : {x_first, y_first})
      orders.outside_px =
          std::max({orders.outside_px, after.x_px - kDesktop.right_px, after.y_px - kDesktop.bottom_px});
    orders.difference =
        std::max({orders.difference, std::fabs(x_first.vx_px_per_s / y_first.vx_px_per_s - 1.0),
                  std::fabs(x_first.vy_px_per_s / y_first.vy_px_per_s - 1.0)});
  }
  return orders;
}

Finding x_before_y(const Core& core) {
  if (steps_that_differ_from_listing(core, 5000) > 0) return {.remark = kOrderOfOther};
  const CornerOrders orders = corner_orders(core);
  return {orders.difference, holds_if(orders.difference > 1e-9),
          orders.outside_px > 0.0
              ? "up to " + digits(orders.outside_px) + " px penetrate in one of the orders"
              : "nothing penetrates in either order"};
}

}  // namespace

std::vector<Claim> wall_claims(const Core& core) {
  const Reach reach = reach_of_throws(core);
  const double restitution = core.constants->restitution;
  const double out_px = std::max(kSpriteSide_px / 2 - reach.x_px.least,
                                 reach.x_px.most - (kDesktop.right_px + kSpriteSide_px / 2));
  return {
      {{"3-centre", "the centre of the sprite cannot cross the inner bounds 0 .. W - w, 0 .. H - h",
        "how far the sprite would stick out of the window if x were its centre", "<= 0", "px"},
       {out_px, holds_if(out_px <= 0.0),
        "the top left corner was at " + digits(reach.x_px.least) + " .. " + digits(reach.x_px.most) +
            " px in x, " + digits(reach.y_px.least) + " .. " + digits(reach.y_px.most) + " px in y"}},
      {{"3-x-first", "collisions are resolved in x first, then y, to prevent double-penetration issues",
        "largest relative difference that the order makes, 1000 corners", "> 1e-9"},
       x_before_y(core)},
      {{"3-exact-position", "each collision corrects the position exactly to the boundary",
        "largest distance from the bound after a clamp, 200 throws", "0", "px"},
       if_met(std::min(reach.side_contacts, reach.ground_contacts),
              {reach.clamp_error_px, holds_if(reach.clamp_error_px == 0.0)})},
      {{"3-restitution", "each collision applies a coefficient of restitution",
        "ratio of the step's normal speeds after and before, at the side walls", "0 .. 1, one value"},
       if_met(reach.side_bounces,
              {reach.ratio.least,
               holds_if(is_close(reach.ratio.least, reach.ratio.most) && reach.ratio.least > 0.0 &&
                        reach.ratio.most < 1.0),
               is_close(reach.ratio.least, reach.ratio.most) ? "" : "up to " + digits(reach.ratio.most)})},
      {{"3.1-no-friction", "vertical velocity is unchanged at the side walls, no friction is applied",
        "largest change of vy at a side wall", "0", "px/s"},
       if_met(reach.side_bounces,
              {reach.vy_change_at_walls_px_per_s, holds_if(reach.vy_change_at_walls_px_per_s == 0.0)})},
      {{"3.2.1-top", "if y < 0, clamp y = 0 and invert the vertical speed", "ratio of vy after and before",
        digits(-restitution)},
       ceiling(core)},
      {{"3.2.2-friction", "ground contact applies ground friction to vx",
        "factor of vx at a ground contact, 200 throws", "< 1, one value"},
       if_met(reach.slides,
              {reach.friction.least, holds_if(is_close(reach.friction.least, reach.friction.most, 1e-9) &&
                                              reach.friction.most < 1.0)})},
      {{"3.2.2-signed", "if vy < epsilon, set vy = 0", "vy that a bounce from 800 px/s leaves", "0", "px/s"},
       threshold_in_words(core, reach)},
      {{"3.2.2-only-on-ground", "friction reduces horizontal speed only while the sprite is on the ground",
        "largest relative change of vx in a step off the ground and the walls, beside drag", "0"},
       {reach.vx_change_in_flight, holds_if(reach.vx_change_in_flight == 0.0)}},
      {{"5-energy-retention", "RESTITUTION: energy retention after bounce",
        "ratio of kinetic energies after and before a bounce", digits(restitution)},
       if_met(reach.side_bounces,
              {reach.energy_ratio, holds_if(is_close(reach.energy_ratio, restitution, 1e-9)),
               is_close(reach.energy_ratio, restitution, 1e-9) ? ""
               : is_close(reach.energy_ratio, restitution * restitution, 1e-9)
                   ? "it is the ratio of speeds, " + digits(restitution) + ", squared"
                   : "neither RESTITUTION, " + digits(restitution) + ", nor its square"})}};
}

}  // namespace hyrax

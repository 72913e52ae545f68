#include "sim/replay/core.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "sim/motion/step.h"
#include "sim/physics/physics.h"
#include "sim/replay/core_constants.h"
#include "sim/scenario/split_mix64.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

physics in(const State& body) { return {body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s}; }
State out(const physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }

bool steps_as_listing(const State& from, double dt_s, const Bounds& bounds) {
  constexpr int kSpriteWidth_px = 128, kSpriteHeight_px = 100;
  State listed = from;
  ListingStep(core_constants(), AllParts{}, bounds)(listed, dt_s);
  physics moving = in(from);
  moving.update(dt_s, static_cast<int>(bounds.right_px) + kSpriteWidth_px,
                static_cast<int>(bounds.bottom_px) + kSpriteHeight_px, kSpriteWidth_px, kSpriteHeight_px);
  return same_bits(out(moving), listed);
}

bool sets_as_listing() {
  physics body(1.0, 2.0, 3.0, 4.0);
  body.setPos(5.0, 6.0);
  body.setVelocity(7.0, 8.0);
  if (!same_bits(out(body), State{5.0, 6.0, 7.0, 8.0})) return false;
  body.resetVelocity();
  return same_bits(out(body), State{5.0, 6.0, 0.0, 0.0});
}

// Each coordinate on a bound, an ulp beside it, and far away; speeds that end below and above the rest
// rule's.
bool is_listing_on_grid() {
  const Constants core = core_constants();
  const auto around = [](double bound) {
    return std::array{bound, std::nextafter(bound, -HUGE_VAL), std::nextafter(bound, HUGE_VAL)};
  };
  for (const Bounds& bounds : {Bounds{1792.0, 952.0}, Bounds{0.0, 0.0}, Bounds{-28.0, -68.0}})
    for (const double dt_s : {0.0, 1.0 / 60.0, 0.5}) {
      std::vector<double> xs = {-50.0, 300.5, 5000.0}, ys = {-50.0, 300.5, 5000.0};
      for (const double bound : {0.0, bounds.right_px})
        std::ranges::copy(around(bound), std::back_inserter(xs));
      for (const double bound : {0.0, bounds.bottom_px})
        std::ranges::copy(around(bound), std::back_inserter(ys));
      std::vector<double> speeds = {0.0, -0.0, 900.25, -900.25, -core.gravity_px_per_s2 * dt_s};
      std::ranges::copy(around(core.rest_threshold_px_per_s / core.restitution), std::back_inserter(speeds));
      for (const double x_px : xs)
        for (const double y_px : ys)
          for (const double vx_px_per_s : {0.0, 700.125, -1300.5})
            for (const double vy_px_per_s : speeds)
              if (!steps_as_listing({x_px, y_px, vx_px_per_s, vy_px_per_s}, dt_s, bounds)) return false;
    }
  return true;
}

// Bodies in windows of many sizes, at many rates, moved to random places at random speeds: only these show a
// limit of speed, or state that a step keeps.
bool is_listing_in_flings() {
  constexpr std::uint64_t kSeed = 1;
  constexpr int kFlings = 100, kFrames = 1000, kFramesOfOne = 100;
  std::uint64_t draws = 0;
  const auto between = [&](double low, double high) {
    return low + (high - low) * split_mix64_unit(kSeed, draws++);
  };
  const auto speed_px_per_s = [&] {
    return std::copysign(std::pow(10.0, between(-3.0, 12.0)), between(-1.0, 1.0));
  };
  for (int fling = 0; fling < kFlings; ++fling) {
    const Bounds bounds{std::floor(between(0.0, 4000.0)), std::floor(between(0.0, 3000.0))};
    const double dt_s = std::pow(10.0, between(-3.0, -0.5));
    const ListingStep step(core_constants(), AllParts{}, bounds);
    physics moving = in(State{});
    State listed;
    for (int frame = 0; frame < kFrames; ++frame) {
      if (frame % kFramesOfOne == 0) {
        listed = {between(0.0, bounds.right_px), between(0.0, bounds.bottom_px), speed_px_per_s(),
                  speed_px_per_s()};
        moving.setPos(listed.x_px, listed.y_px);
        moving.setVelocity(listed.vx_px_per_s, listed.vy_px_per_s);
      }
      step(listed, dt_s);
      moving.update(dt_s, static_cast<int>(bounds.right_px), static_cast<int>(bounds.bottom_px), 0, 0);
      if (!same_bits(out(moving), listed)) return false;
    }
  }
  return true;
}

}  // namespace

State core_step(const State& body, double dt_s, const Bounds& bounds) {
  return core_steps(body, dt_s, bounds, 1);
}

State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps) {
  physics moving = in(body);
  assert(bounds.right_px == std::trunc(bounds.right_px) && bounds.bottom_px == std::trunc(bounds.bottom_px));
  const int right_px = static_cast<int>(bounds.right_px);
  const int bottom_px = static_cast<int>(bounds.bottom_px);
  for (std::int64_t step = 0; step < steps; ++step) moving.update(dt_s, right_px, bottom_px, 0, 0);
  return out(moving);
}

State core_played(const State& body, std::span<const double> frames_s, const Bounds& bounds, int parts) {
  physics moving = in(body);
  const int right_px = static_cast<int>(bounds.right_px);
  const int bottom_px = static_cast<int>(bounds.bottom_px);
  if (parts == 1) {
    for (const double frame_s : frames_s) moving.update(frame_s, right_px, bottom_px, 0, 0);
  } else {
    for (const double frame_s : frames_s)
      for (int part = 0; part < parts; ++part) moving.update(frame_s / parts, right_px, bottom_px, 0, 0);
  }
  return out(moving);
}

State core_stopped(const State& body) {
  physics moving = in(body);
  moving.resetVelocity();
  return out(moving);
}

// In the largest window there is, most flights meet no wall. One that does flies again at the same velocity
// in the middle of the window: its speeds are those of the flight, and so is its distance, to the rounding of
// such a place. If that distance is speed times dt, as the listing moves, the position is exact; else to
// that rounding.
State core_flight(const State& body, double dt_s) {
  constexpr int kSide_px = std::numeric_limits<int>::max();
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const auto flown = [dt_s](const State& from) {
    physics moving = in(from);
    moving.update(dt_s, kSide_px, kSide_px, 0, 0);
    return out(moving);
  };
  const auto is_inside = [](double at_px) { return at_px > 0.0 && at_px < kSide_px; };
  State end = flown(body);
  if (is_inside(end.x_px) && is_inside(end.y_px)) return end;
  State way{0.0, 0.0, body.vx_px_per_s, body.vy_px_per_s};
  ListingStep(core_constants(), AllParts{}, Bounds{}).fly(way, dt_s);
  const State middle{0.5 * kSide_px - way.x_px, 0.5 * kSide_px - way.y_px, body.vx_px_per_s,
                     body.vy_px_per_s};
  const State there = flown(middle);
  const auto moved = [&](double from_px, double distance_px, double listing_px) {
    const double rounding_px = kRounding * (kSide_px + std::fabs(listing_px));
    return from_px + (std::fabs(distance_px - listing_px) > rounding_px ? distance_px : listing_px);
  };
  if (!is_inside(end.x_px)) end.x_px = moved(body.x_px, there.x_px - middle.x_px, there.vx_px_per_s * dt_s);
  if (!is_inside(end.y_px)) end.y_px = moved(body.y_px, there.y_px - middle.y_px, there.vy_px_per_s * dt_s);
  return {end.x_px, end.y_px, there.vx_px_per_s, there.vy_px_per_s};
}

bool core_is_listing() {
  static const bool is_listing =
      is_paper_model(core_model()) && sets_as_listing() && is_listing_on_grid() && is_listing_in_flings();
  return is_listing;
}

}  // namespace hyrax

#include "sim/replay/kernel.h"

#include <bit>

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

constexpr std::uint8_t bit(Wall wall) { return static_cast<std::uint8_t>(wall); }

bool same_state(const physics& body, const Body& other) {
  return same_bits(body.vy(), other.vy_px_per_s) && same_bits(body.y(), other.y_px) &&
         same_bits(body.x(), other.x_px) && same_bits(body.vx(), other.vx_px_per_s);
}

// A clamp corrects the position, so it shows in the difference between the flight without walls
// and the state after the step. The flight is the core's own first half of update.
class ClampObserver {
 public:
  ClampObserver(const Stretch& stretch, StretchLog& log) : stretch_(stretch), log_(log) {}

  // Contact byte of the row `offset` that `before` came to as `after`.
  std::uint8_t observe(physics before, const physics& after, double dt_s, std::uint8_t contact_before,
                       std::int64_t offset) {
    physics flight = before;
    flight.fly(dt_s);
    std::uint8_t contact = 0;
    if (flight.x() < after.x()) contact |= bit(Wall::left);
    if (flight.x() > after.x()) contact |= bit(Wall::right);
    if (flight.y() < after.y()) contact |= bit(Wall::top);
    if (flight.y() > after.y()) contact |= bit(Wall::ground);
    if (touches(contact, Wall::ground)) {
      if (flight.vx() != 0.0) log_.had_friction = true;
      if (after.vy() == 0.0) contact |= kRestBit;
    }
    if (contact != 0) count(contact);
    const auto begun = static_cast<std::uint8_t>(contact & ~contact_before & ~kRestBit);
    if (begun != 0) begin(begun, flight, after, offset);
    return contact;
  }

 private:
  void count(std::uint8_t contact) {
    for (const Wall wall : kWalls)
      if (touches(contact, wall)) ++log_.clamped_steps[wall_index(wall)];
    if ((contact & kRestBit) != 0) ++log_.rest_steps;
  }

  void begin(std::uint8_t begun, const physics& flight, const physics& after, std::int64_t offset) {
    const physics turned_in_x = after_wall_in_x(flight);
    for (const Wall wall : {Wall::left, Wall::right})
      if (touches(begun, wall)) record(wall, flight, turned_in_x, after, flight.x() - after.x(), offset);
    for (const Wall wall : {Wall::top, Wall::ground})
      if (touches(begun, wall)) record(wall, turned_in_x, after, after, flight.y() - after.y(), offset);
  }

  // The walls in x alone: at y = 0 in a window as high as the sprite nothing touches in y.
  physics after_wall_in_x(physics flight) const {
    flight.setPos(flight.x(), 0.0);
    flight.collide(stretch_.window.width_px, stretch_.sprite.height_px, stretch_.sprite.width_px,
                   stretch_.sprite.height_px);
    return flight;
  }

  void record(Wall wall, const physics& met, const physics& left, const physics& row, double overshoot_px,
              std::int64_t offset) {
    log_.begun.push_back({offset,
                          {.wall = wall,
                           .x_px = row.x(),
                           .y_px = row.y(),
                           .vx_before_px_per_s = met.vx(),
                           .vy_before_px_per_s = met.vy(),
                           .vx_after_px_per_s = left.vx(),
                           .vy_after_px_per_s = left.vy(),
                           .overshoot_px = overshoot_px < 0.0 ? -overshoot_px : overshoot_px}});
  }

  const Stretch& stretch_;
  StretchLog& log_;
};

// The state stays in a local body, which nothing else points to, so that it can live in registers.
template <bool kIsDtFixed, bool kSeeksAnchor>
physics play_free(const Stretch& stretch, physics body, std::byte* row, StretchLog& log) {
  const Size window = stretch.window;
  const Size sprite = stretch.sprite;
  const double right_px = static_cast<double>(window.width_px - sprite.width_px);
  const double bottom_px = static_cast<double>(window.height_px - sprite.height_px);
  ClampObserver observer(stretch, log);
  std::uint8_t contact = stretch.contact_before;
  for (std::int64_t frame = 0; frame < stretch.frames; ++frame) {
    const double dt_s = stretch.dt_s[kIsDtFixed ? 0 : frame];
    const physics before = body;
    body.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
    const bool stands_on_a_bound =
        body.x() == 0.0 || body.x() == right_px || body.y() == 0.0 || body.y() == bottom_px;
    contact = stands_on_a_bound ? observer.observe(before, body, dt_s, contact, frame) : std::uint8_t{0};
    pack_row(row, dt_s, body.x(), body.y(), body.vx(), body.vy(), contact);
    row += kPackedRowBytes;
    ++log.frames;
    if (kSeeksAnchor && same_state(body, *stretch.anchor)) {
      log.met_anchor = true;
      break;
    }
  }
  return body;
}

// Frames pass, no update, contact 0.
void play_held(const Stretch& stretch, const physics& body, std::byte* row, StretchLog& log) {
  for (std::int64_t frame = 0; frame < stretch.frames && !log.met_anchor; ++frame) {
    pack_row(row, stretch.dt_s[stretch.is_dt_fixed ? 0 : frame], body.x(), body.y(), body.vx(), body.vy(), 0);
    row += kPackedRowBytes;
    ++log.frames;
    log.met_anchor = stretch.anchor != nullptr && same_state(body, *stretch.anchor);
  }
}

physics play_any(const Stretch& stretch, const physics& body, std::byte* row, StretchLog& log) {
  if (stretch.is_held) {
    play_held(stretch, body, row, log);
    return body;
  }
  if (!stretch.is_dt_fixed) return play_free<false, false>(stretch, body, row, log);
  if (stretch.anchor == nullptr) return play_free<true, false>(stretch, body, row, log);
  return play_free<true, true>(stretch, body, row, log);
}

}  // namespace

void play(const Stretch& stretch, Body& body, RowBlock& rows, StretchLog& log) {
  log.frames = 0;
  log.met_anchor = false;
  log.had_friction = false;
  log.clamped_steps = {};
  log.rest_steps = 0;
  log.begun.clear();
  const std::size_t rows_before = rows.size();
  std::byte* const row = rows.extend(static_cast<std::size_t>(stretch.frames));
  const physics moved =
      play_any(stretch, physics(body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s), row, log);
  rows.shrink(rows_before + static_cast<std::size_t>(log.frames));
  body = {moved.x(), moved.y(), moved.vx(), moved.vy()};
}

}  // namespace hyrax

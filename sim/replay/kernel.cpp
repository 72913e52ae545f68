#include "sim/replay/kernel.h"

#include <bit>

#include "sim/physics/physics.h"

namespace hyrax {
namespace {

physics core_of(const Row& row) { return physics(row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s); }

State state_of(const physics& body) { return {body.x(), body.y(), body.vx(), body.vy()}; }

constexpr std::uint8_t bit(Wall wall) { return static_cast<std::uint8_t>(wall); }

// Contact byte of the step that came to `after`. A clamp corrects the position, so it shows in the
// difference to the flight without walls, which is the core's own first half of update. Branches
// serve better than selects here: bounces come seldom, and rest repeats itself.
std::uint8_t contact_of(const physics& flight, const physics& after) {
  std::uint8_t contact = 0;
  if (flight.y() > after.y())
    contact = static_cast<std::uint8_t>(bit(Wall::ground) | (after.vy() == 0.0 ? kRestBit : 0));
  else if (flight.y() < after.y())
    contact = bit(Wall::top);
  if (flight.x() < after.x()) return static_cast<std::uint8_t>(contact | bit(Wall::left));
  if (flight.x() > after.x()) return static_cast<std::uint8_t>(contact | bit(Wall::right));
  return contact;
}

Contact begun_contact(Wall wall, const physics& met, const physics& left, const physics& row,
                      double overshoot_px) {
  return {.wall = wall,
          .x_px = row.x(),
          .y_px = row.y(),
          .vx_before_px_per_s = met.vx(),
          .vy_before_px_per_s = met.vy(),
          .vx_after_px_per_s = left.vx(),
          .vy_after_px_per_s = left.vy(),
          .overshoot_px = overshoot_px < 0.0 ? -overshoot_px : overshoot_px};
}

// The walls in x alone: at y = 0 in a window as high as the sprite nothing touches in y.
physics after_wall_in_x(const Stretch& stretch, physics flight) {
  flight.setPos(flight.x(), 0.0);
  flight.collide(stretch.window.width_px, stretch.sprite.height_px, stretch.sprite.width_px,
                 stretch.sprite.height_px);
  return flight;
}

// A step in which walls begin or cease to clamp; seldom, so it is kept out of the loop. It takes copies:
// a state whose address is known elsewhere could not stay in registers.
[[gnu::noinline]] void log_change(const Stretch& stretch, std::uint8_t contact_before, std::uint8_t contact,
                                  physics flight, double dt_s, physics after, std::int64_t offset,
                                  StretchLog& log) {
  flight.fly(dt_s);
  const physics turned_in_x = after_wall_in_x(stretch, flight);
  for (const Wall wall : kWalls) {
    if (touches(contact, wall) == touches(contact_before, wall)) continue;
    const bool is_in_x = wall == Wall::left || wall == Wall::right;
    if (!touches(contact, wall))
      log.changes.push_back({offset, false, {.wall = wall}});
    else if (is_in_x)
      log.changes.push_back(
          {offset, true, begun_contact(wall, flight, turned_in_x, after, flight.x() - after.x())});
    else
      log.changes.push_back(
          {offset, true, begun_contact(wall, turned_in_x, after, after, flight.y() - after.y())});
  }
}

constexpr bool is_change(std::uint8_t contact_before, std::uint8_t contact) {
  return ((contact_before ^ contact) & ~kRestBit) != 0;
}

// State and anchor stay in locals, which nothing else points to, so that they can live in registers.
template <bool kIsDtFixed, bool kSeeksAnchor>
physics play_free(const Stretch& stretch, physics body, RestAnchor& rest_anchor, std::byte* row,
                  StretchLog& log) {
  const Size window = stretch.window;
  const Size sprite = stretch.sprite;
  const double right_px = static_cast<double>(window.width_px - sprite.width_px);
  const double bottom_px = static_cast<double>(window.height_px - sprite.height_px);
  const std::int64_t frames = stretch.frames;
  const double* const frame_dt_s = stretch.dt_s;
  const double fixed_dt_s = frame_dt_s[0];
  RestAnchor rest = rest_anchor;
  std::int64_t moved_offset = -1;
  std::uint8_t contact = stretch.contact_before;
  std::int64_t frame = 0;
  while (frame < frames) {
    const double dt_s = kIsDtFixed ? fixed_dt_s : frame_dt_s[frame];
    const physics before = body;
    const std::uint8_t contact_before = contact;
    body.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
    contact = 0;
    // Only a clamp, or great chance, puts the sprite onto a bound. One branch, not four.
    const unsigned is_on_a_bound = unsigned{body.x() == 0.0} | unsigned{body.x() == right_px} |
                                   unsigned{body.y() == 0.0} | unsigned{body.y() == bottom_px};
    if (is_on_a_bound != 0) {
      physics flight = before;
      flight.fly(dt_s);
      contact = contact_of(flight, body);
      ++log.rows[contact];
      log.had_friction |= touches(contact, Wall::ground) && flight.vx() != 0.0;
    }
    pack_row(row, dt_s, body.x(), body.y(), body.vx(), body.vy(), contact);
    row += kPackedRowBytes;
    if (is_change(contact_before, contact))
      log_change(stretch, contact_before, contact, before, dt_s, body, frame, log);
    if (rest.moves_to(body.x(), body.y())) moved_offset = frame;
    ++frame;
    if (kSeeksAnchor && same_bits(state_of(body), *stretch.anchor)) {
      log.met_anchor = true;
      break;
    }
  }
  log.frames = frame;
  log.moved_offset = moved_offset;
  rest_anchor = rest;
  return body;
}

// Frames pass, no update, contact 0.
void play_held(const Stretch& stretch, const physics& body, RestAnchor& rest, std::byte* row,
               StretchLog& log) {
  if (is_change(stretch.contact_before, 0))
    log_change(stretch, stretch.contact_before, 0, body, 0.0, body, 0, log);
  if (rest.moves_to(body.x(), body.y())) log.moved_offset = 0;
  while (log.frames < stretch.frames && !log.met_anchor) {
    pack_row(row, stretch.dt_s[stretch.is_dt_fixed ? 0 : log.frames], body.x(), body.y(), body.vx(),
             body.vy(), 0);
    row += kPackedRowBytes;
    ++log.frames;
    log.met_anchor = stretch.anchor != nullptr && same_bits(state_of(body), *stretch.anchor);
  }
}

physics play_any(const Stretch& stretch, const physics& body, RestAnchor& rest, std::byte* row,
                 StretchLog& log) {
  if (stretch.is_held) {
    play_held(stretch, body, rest, row, log);
    return body;
  }
  if (!stretch.is_dt_fixed) return play_free<false, false>(stretch, body, rest, row, log);
  if (stretch.anchor == nullptr) return play_free<true, false>(stretch, body, rest, row, log);
  return play_free<true, true>(stretch, body, rest, row, log);
}

}  // namespace

void play(const Stretch& stretch, State& body, RestAnchor& rest, RowBlock& rows, StretchLog& log) {
  log.frames = 0;
  log.met_anchor = false;
  log.had_friction = false;
  log.rows = {};
  log.changes.clear();
  log.moved_offset = -1;
  const std::size_t rows_before = rows.size();
  std::byte* const row = rows.extend(static_cast<std::size_t>(stretch.frames));
  const physics moved =
      play_any(stretch, physics(body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s), rest, row, log);
  rows.shrink(rows_before + static_cast<std::size_t>(log.frames));
  body = state_of(moved);
}

void fling(Row& row, const Velocity& velocity) {
  physics core = core_of(row);
  core.setVelocity(velocity.vx_px_per_s, velocity.vy_px_per_s);
  set_state(row, state_of(core));
}

void place(Row& row, const Position& position) {
  physics core = core_of(row);
  core.setPos(position.x_px, position.y_px);
  set_state(row, state_of(core));
}

void stop(Row& row) {
  physics core = core_of(row);
  core.resetVelocity();
  set_state(row, state_of(core));
}

}  // namespace hyrax

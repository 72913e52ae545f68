#include "sim/core/contact_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/motion/step.h"

namespace hyrax {
namespace {

// The contacts of rows that were played from `from`. @param contact_of of a step: contact byte of (from, dt,
// after). @param meeting_at what that step did at a wall: (wall, from, dt, after).
template <class ContactOf, class MeetingAt>
void tell_contacts(const Stretch& stretch, State from, std::size_t first_row, RowBlock& rows, StretchLog& log,
                   const ContactOf& contact_of, const MeetingAt& meeting_at) {
  log.rows = {};
  log.changes.clear();
  log.had_friction = false;
  std::uint8_t contact_before = stretch.contact_before;
  for (std::int64_t offset = 0; offset < log.frames; ++offset) {
    const std::size_t index = first_row + static_cast<std::size_t>(offset);
    const Row row = rows.row(index);
    const State after = state_of(row);
    const std::uint8_t contact = contact_of(from, row.dt_s, after);
    rows.set_contact(index, contact);
    if (contact != 0) ++log.rows[contact];
    log.had_friction |= touches(contact, Wall::ground) && from.vx_px_per_s != 0.0;
    if (is_contact_change(contact_before, contact))
      log_contact_changes(contact_before, contact, after, offset, log,
                          [&](Wall wall) { return meeting_at(wall, from, row.dt_s, after); });
    contact_before = contact;
    from = after;
  }
}

// One coordinate and its speed.
struct Motion {
  double at_px;
  double v_px_per_s;
};

std::uint8_t with_rest_bit(std::uint8_t walls, const State& after) {
  const bool rests = touches(walls, Wall::ground) && after.vy_px_per_s == 0.0;
  return static_cast<std::uint8_t>(walls | (rests ? kRestBit : 0));
}

WallMeeting meeting_of_rows(const State& before, const State& after) {
  return {std::numeric_limits<double>::quiet_NaN(), velocity_of(before), velocity_of(after)};
}

// @param walls that the step tells; the rows tell the others.
void tell_by_step(const Stretch& stretch, const State& start, TracedBody& traced, std::uint8_t walls,
                  std::size_t first_row, RowBlock& rows, StretchLog& log) {
  TracedBody before = traced;
  const Bounds bounds = bounds_of(stretch.window, stretch.sprite);
  tell_contacts(
      stretch, start, first_row, rows, log,
      [&](const State& from, double dt_s, const State& after) {
        traced.set_row(from);
        before = traced;
        traced.update(dt_s, stretch.window.width_px, stretch.window.height_px, stretch.sprite.width_px,
                      stretch.sprite.height_px);
        const int others =
            walls == kAllWalls ? 0 : contact_of_rows(bounds, from, dt_s, after) & kAllWalls & ~walls;
        return with_rest_bit(static_cast<std::uint8_t>((traced.contact() & walls) | others), after);
      },
      [&](Wall wall, const State& from, double dt_s, const State& after) {
        return touches(walls, wall) ? before.meeting(wall, dt_s, stretch.window, stretch.sprite)
                                    : meeting_of_rows(from, after);
      });
}

// Where the row is what the paper's step makes of the one before, its contacts are that step's.
void tell_by_rows(const Stretch& stretch, const State& start, const std::optional<Constants>& constants,
                  std::size_t first_row, RowBlock& rows, StretchLog& log) {
  const Bounds bounds = bounds_of(stretch.window, stretch.sprite);
  const ListingStep listing(constants.value_or(Constants()), AllParts{}, bounds);
  bool is_listed = false;
  tell_contacts(
      stretch, start, first_row, rows, log,
      [&](const State& from, double dt_s, const State& after) {
        State listed = from;
        const std::uint8_t met = listing(listed, dt_s);
        is_listed = constants && same_bits(listed, after);
        return is_listed ? with_rest_bit(met, after) : contact_of_rows(bounds, from, dt_s, after);
      },
      [&](Wall wall, const State& from, double dt_s, const State& after) {
        if (is_listed) return listing_meeting(listing, wall, from, dt_s, after);
        return meeting_of_rows(from, after);
      });
}

// The wall at 0 or at `high_px` that one coordinate met.
std::uint8_t met(const Motion& before, double dt_s, const Motion& after, double high_px, Wall low,
                 Wall high) {
  const double reach_px = std::max(std::fabs(before.v_px_per_s), std::fabs(after.v_px_per_s)) * dt_s;
  const bool turned_up = before.v_px_per_s < 0.0 && after.v_px_per_s > 0.0;
  const bool turned_down = before.v_px_per_s > 0.0 && after.v_px_per_s < 0.0;
  if (after.at_px <= 0.0 || (turned_up && before.at_px <= reach_px)) return static_cast<std::uint8_t>(low);
  if (after.at_px >= high_px || (turned_down && high_px - before.at_px <= reach_px))
    return static_cast<std::uint8_t>(high);
  return 0;
}

}  // namespace

std::uint8_t contact_of_rows(const Bounds& bounds, const State& before, double dt_s, const State& after) {
  const std::uint8_t in_x = met({before.x_px, before.vx_px_per_s}, dt_s, {after.x_px, after.vx_px_per_s},
                                bounds.right_px, Wall::left, Wall::right);
  const std::uint8_t in_y = met({before.y_px, before.vy_px_per_s}, dt_s, {after.y_px, after.vy_px_per_s},
                                bounds.bottom_px, Wall::top, Wall::ground);
  return with_rest_bit(static_cast<std::uint8_t>(in_x | in_y), after);
}

void ContactStepper::tell(const Stretch& stretch, const State& from, std::span<TracedBody> bodies,
                          std::size_t first_row, RowBlock& rows, StretchLog& log) const {
  if (walls_ != 0)
    tell_by_step(stretch, from, bodies.front(), walls_, first_row, rows, log);
  else
    tell_by_rows(stretch, from, constants_, first_row, rows, log);
}

}  // namespace hyrax

// The contacts that begin and end in the rows of a stretch.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/core/kernel.h"

namespace hyrax {

[[nodiscard]] constexpr bool is_contact_change(std::uint8_t contact_before, std::uint8_t contact) {
  return ((contact_before ^ contact) & ~kRestBit) != 0;
}

/// Logs the walls that begin or cease to clamp in row `offset`; none if the contact bytes are alike.
/// @param row its state. @param meeting_at what the step did at a wall that begins: WallMeeting(Wall).
template <class MeetingAt>
void log_contact_changes(std::uint8_t contact_before, std::uint8_t contact, const State& row,
                         std::int64_t offset, StretchLog& log, const MeetingAt& meeting_at) {
  for (const Wall wall : kWalls) {
    if (touches(contact, wall) == touches(contact_before, wall)) continue;
    ContactChange change{.offset = offset, .begins = touches(contact, wall), .contact = {.wall = wall}};
    if (change.begins) {
      const WallMeeting meeting = meeting_at(wall);
      change.contact.x_px = row.x_px;
      change.contact.y_px = row.y_px;
      change.contact.vx_before_px_per_s = meeting.before.vx_px_per_s;
      change.contact.vy_before_px_per_s = meeting.before.vy_px_per_s;
      change.contact.vx_after_px_per_s = meeting.after.vx_px_per_s;
      change.contact.vy_after_px_per_s = meeting.after.vy_px_per_s;
      change.contact.overshoot_px = meeting.overshoot_px;
    }
    log.changes.push_back(change);
  }
}

/// What the listing's step from `from` to `after` did at a wall that it met.
/// @tparam Listing has `fly` and `meet_walls_in_x` as ListingStep (sim/motion/step.h).
template <class Listing>
[[nodiscard]] WallMeeting listing_meeting(const Listing& listing, Wall wall, const State& from, double dt_s,
                                          const State& after) {
  State flight = from;
  listing.fly(flight, dt_s);
  State between_walls = flight;
  listing.meet_walls_in_x(between_walls);
  if (wall == Wall::left || wall == Wall::right)
    return {std::fabs(flight.x_px - after.x_px), velocity_of(flight), velocity_of(between_walls)};
  return {std::fabs(flight.y_px - after.y_px), velocity_of(between_walls), velocity_of(after)};
}

}  // namespace hyrax

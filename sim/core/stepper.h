// What the replay asks of a core: the frames of one stretch, packed into rows, and the effect of actions.
//
// A stretch has no input: its sizes and whether the sprite is held do not change.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/run_summary.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

inline constexpr std::uint8_t kAllWalls = 15;  ///< As a contact byte.

/// What moves. `object` as Keyframe::core_object.
struct CoreBody {
  State state;
  std::vector<std::byte> object = {};
};

/// What to play.
struct Stretch {
  Size window;
  Size sprite;
  bool is_held = false;
  std::uint8_t contact_before = 0;  ///< Contact byte of the row before the first frame.
  const double* dt_s = nullptr;     ///< One dt, or one a frame.
  bool is_dt_fixed = true;
  std::int64_t frames = 0;
  std::int64_t from_step = 0;        ///< The row before the first frame.
  const CoreBody* anchor = nullptr;  ///< Ends the stretch early at the row whose body has these bits.
};

/// A wall begins or ceases to clamp in row `offset` of the stretch.
struct ContactChange {
  std::int64_t offset = 0;
  bool begins = false;
  Contact contact;  ///< Of one that ceases only the wall; of one that begins all but steps and time.
};

/// What happened; reused from stretch to stretch.
struct StretchLog {
  std::int64_t frames = 0;  ///< Played.
  bool met_anchor = false;
  bool had_friction = false;            ///< A ground contact met a sprite that slid.
  std::array<std::int64_t, 32> rows{};  ///< By contact byte; rows in flight are not counted.
  std::vector<ContactChange> changes;   ///< By offset; in a corner x before y.
  std::int64_t moved_offset = -1;       ///< The last row that became the anchor of rest; -1: none.

  [[nodiscard]] std::int64_t rows_with(std::uint8_t contact_bit) const {
    std::int64_t count = 0;
    for (std::size_t contact = 0; contact < rows.size(); ++contact)
      if ((contact & contact_bit) != 0) count += rows[contact];
    return count;
  }
};

/// How a core plays: a stretch at a time, so that its state stays in registers in between; and, for checks
/// and studies, from one plain state to another. REQUIRES of the latter: bounds that are whole numbers within
/// the range of int.
class Stepper {
 public:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  virtual ~Stepper() = default;

  /// Plays the stretch: moves `body` and the anchor of rest, and appends a row a frame to `rows`.
  /// REQUIRES: stretch.frames <= rows.room().
  virtual void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
                    StretchLog& log) const = 0;
  /// Applies an action by the core's own setters.
  virtual void apply(const Action& action, Keyframe& now) const = 0;
  /// `steps` calls of update with one dt.
  [[nodiscard]] virtual State steps(const State& body, double dt_s, const Bounds& bounds,
                                    std::int64_t steps) const = 0;
  /// Calls of update through the frames, each in so many equal parts.
  [[nodiscard]] virtual State played(const State& body, std::span<const double> frames_s,
                                     const Bounds& bounds, int parts) const = 0;
};

/// Plays as another stepper does: base of those that add something to some of its calls.
class StepperOver : public Stepper {
 public:
  explicit StepperOver(std::shared_ptr<const Stepper> stepper) : stepper_(std::move(stepper)) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    stepper_->play(stretch, body, rest, rows, log);
  }
  void apply(const Action& action, Keyframe& now) const override { stepper_->apply(action, now); }
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    return stepper_->steps(body, dt_s, bounds, steps);
  }
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts) const override {
    return stepper_->played(body, frames_s, bounds, parts);
  }

 private:
  std::shared_ptr<const Stepper> stepper_;
};

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
/// @tparam Step has `fly` and `meet_walls_in_x` as ListingStep (sim/motion/step.h).
template <class Step>
[[nodiscard]] WallMeeting listing_meeting(const Step& step, Wall wall, const State& from, double dt_s,
                                          const State& after) {
  State flight = from;
  step.fly(flight, dt_s);
  State between_walls = flight;
  step.meet_walls_in_x(between_walls);
  if (wall == Wall::left || wall == Wall::right)
    return {std::fabs(flight.x_px - after.x_px), velocity_of(flight), velocity_of(between_walls)};
  return {std::fabs(flight.y_px - after.y_px), velocity_of(between_walls), velocity_of(after)};
}

}  // namespace hyrax

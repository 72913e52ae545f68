// The ground contacts of a run: bounces, and those with which the sprite comes to rest on the floor.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "sim/motion/state.h"

namespace hyrax {

/// A ground contact is a *resting contact* if, from its first row to the last one before the next input, or
/// to the end of the run, y stays within kNear_px of the floor, and at least one row follows it there; the
/// sprite may slide. Every other contact is a *bounce*. A contact belongs to the stretch between inputs in
/// which it begins; an input acts after a row, the last one of its stretch.
class RestingContact {
 public:
  static constexpr double kNear_px = 0.5;
  [[nodiscard]] static bool is_near(double y_px, double floor_px) {
    return std::fabs(y_px - floor_px) <= kNear_px;
  }

  /// A row of a run whose rows all come by in order.
  void row(std::int64_t step, std::uint8_t contact_before, std::uint8_t contact, double y_px,
           double floor_px) {
    enter(step, contact_before, contact);
    if (touches(contact, Wall::ground) && !touches(contact_before, Wall::ground)) begin(step);
    if (from_step_ && !is_near(y_px, floor_px)) leave();
  }

  // Its parts, for rows most of which need not be looked at: the row after an input, the row of a ground
  // contact's begin, and, while one is open, a row that is not near the floor.
  void enter(std::int64_t step, std::uint8_t contact_before, std::uint8_t contact) {
    if (goes_on_ && touches(contact_before, Wall::ground) && touches(contact, Wall::ground))
      from_step_ = step;
    goes_on_ = false;
  }
  void begin(std::int64_t step) {
    if (!from_step_) from_step_ = step;
    ++begun_;
    last_begun_step_ = step;
  }
  void leave() {
    from_step_.reset();
    begun_ = 0;
  }
  /// The next `passes` times `period` rows are like the last `period`, in which so many ground contacts
  /// began.
  void repeat(std::int64_t step, std::int64_t passes, std::int64_t period, std::int64_t begun) {
    if (!from_step_ || begun == 0) return;
    if (*from_step_ > step - period)
      *from_step_ += passes * period;  // It left the floor in each of them.
    else
      begun_ += passes * begun;
    last_begun_step_ += passes * period;
  }
  /// Ends the stretch with its last row.
  void end(std::int64_t last_step) {
    const bool is_resting = from_step_ && (begun_ == 0 || *from_step_ < last_step);
    const bool ends_with_bounce = begun_ > 0 && last_begun_step_ == last_step;
    stretch_from_step_ = is_resting ? from_step_ : std::nullopt;
    if (is_resting) contacts_ += begun_ - (ends_with_bounce ? 1 : 0);
    goes_on_ = is_resting && !ends_with_bounce;
    leave();
  }

  /// The first row of what is a resting contact if the sprite stays until the stretch ends: each ground
  /// contact that begins from there on.
  [[nodiscard]] std::optional<std::int64_t> open_from_step() const { return from_step_; }
  /// Whether that began before the stretch.
  [[nodiscard]] bool has_gone_on() const { return from_step_ && begun_ == 0; }
  /// Of the stretches that have ended: how many contacts were resting contacts,
  [[nodiscard]] std::int64_t contacts() const { return contacts_; }
  /// and from which row the sprite was in resting contact to the end of the last one; its first row, if a
  /// resting contact went on into it.
  [[nodiscard]] std::optional<std::int64_t> from_step() const { return stretch_from_step_; }

 private:
  std::optional<std::int64_t> from_step_;
  std::int64_t begun_ = 0;
  std::int64_t last_begun_step_ = 0;
  bool goes_on_ = false;
  std::int64_t contacts_ = 0;
  std::optional<std::int64_t> stretch_from_step_;
};

}  // namespace hyrax

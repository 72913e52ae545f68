// What the step adds and takes by itself, against exact flights and bounces, by cause.
#pragma once

#include <cstdint>

#include "sim/reference/drift.h"

namespace hyrax {

/// Energy so far, as the height in px that it lifts the sprite by: gravity once a step, drag on that path,
/// the lift out of walls, restitution after the wall instead of at it.
struct EnergyCauses {
  double gravity = 0.0;
  double drag = 0.0;
  double lift = 0.0;
  double bounce = 0.0;

  [[nodiscard]] double sum() const { return gravity + drag + lift + bounce; }
};

/// Sums them up over arcs and contacts, which come in order of steps.
class EnergyCauseSum {
 public:
  explicit EnergyCauseSum(double gravity_px_per_s2) : gravity_px_per_s2_(gravity_px_per_s2) {}
  [[nodiscard]] const EnergyCauses& now() const { return now_; }
  void add(const ArcErrors& arc) {
    now_.gravity += height(arc.energy_parts.gravity);
    now_.drag += height(arc.energy_parts.drag);
  }
  /// In a corner the lift is the same for both walls, and counts once.
  void add(const ImpactErrors& contact) {
    if (contact.step != last_contact_) now_.lift += height(contact.energy_parts.lift);
    now_.bounce += height(contact.late_bounce_px2_per_s2.value_or(0.0));
    last_contact_ = contact.step;
  }

 private:
  [[nodiscard]] double height(double energy_px2_per_s2) const {
    return energy_px2_per_s2 / gravity_px_per_s2_;
  }

  double gravity_px_per_s2_;
  EnergyCauses now_;
  std::int64_t last_contact_ = -1;
};

}  // namespace hyrax

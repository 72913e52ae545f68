// What the step adds and takes by itself, against exact flights and bounces, by cause.
#pragma once

#include "sim/reference/drift.h"

namespace hyrax {

/// Sums up EnergyCauses over arcs and contacts.
class EnergyCauseSum {
 public:
  /// REQUIRES: gravity > 0 where heights are asked for.
  explicit EnergyCauseSum(double gravity_px_per_s2) : gravity_px_per_s2_(gravity_px_per_s2) {}
  [[nodiscard]] const EnergyCauses& now() const { return now_; }
  void add(const ArcEnergyParts& arc) {
    now_.gravity += height(arc.gravity);
    now_.drag += height(arc.drag);
  }
  void add(const ImpactErrors& contact) {
    now_.bounce += height(contact.bounce_error_px2_per_s2.value_or(0.0));
    if (contact.is_second_of_corner) return;
    now_.lift += height(contact.energy_parts.lift);
    now_.flight += height(contact.flight_error_px2_per_s2);
  }

 private:
  [[nodiscard]] double height(double energy_px2_per_s2) const {
    return energy_px2_per_s2 / gravity_px_per_s2_;
  }

  double gravity_px_per_s2_;
  EnergyCauses now_;
};

}  // namespace hyrax

#include "sim/compare/trajectory_comparer.h"

#include <algorithm>

namespace hyrax {
namespace {

bool is_worse(double difference, double worst) { return !std::isnan(worst) && !(difference <= worst); }

}  // namespace

bool Tolerance::accepts(double a, double b) const {
  if (agrees(a, b)) return true;
  if (!std::isfinite(a) || !std::isfinite(b)) return false;
  if (abs && std::fabs(a - b) <= *abs) return true;
  const double larger = std::max(std::fabs(a), std::fabs(b));
  const double scale = larger > 1.0 ? 0.5 : 1.0;  // The difference of two finite values may overflow.
  if (rel && std::fabs(scale * a - scale * b) <= *rel * (scale * larger)) return true;
  return ulps && *ulps_between(a, b) <= static_cast<std::uint64_t>(*ulps);
}

std::optional<Divergence> first_difference(const std::vector<Contact>& a, const std::vector<Contact>& b,
                                           const Tolerance& tolerance) {
  for (std::size_t index = 0; index < a.size(); ++index)
    for (const ContactColumn& quantity : kContactQuantities) {
      const double left = *quantity.number(a[index]);
      const double right = *quantity.number(b[index]);
      if (!agrees(quantity, a[index], b[index]) && !tolerance.accepts(left, right))
        return Divergence{a[index].step, std::string("contacts/") + quantity.name, left, right};
    }
  return std::nullopt;
}

void TrajectoryComparer::compare(const Row& a, const Row& b) {
  bool differs = false;
  for (std::size_t index = 0; index < kRowFields.size(); ++index) {
    const RowField& field = kRowFields[index];
    const double left = field.value(a);
    const double right = field.value(b);
    if (agrees(left, right)) continue;
    differs = true;
    std::optional<WorstDifference>& worst = worst_[index];
    const WorstDifference found{a.step, left, right};
    if (!worst || is_worse(found.abs(), worst->abs())) worst = found;
    const bool is_accepted = !is_contact_field(field.name) && tolerance_.accepts(left, right);
    if (!is_accepted && !first_) first_ = {a.step, std::string(field.name), left, right};
  }
  if (differs) distance_.add(a, b);
}

void TrajectoryComparer::compare(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  contacts_ = contact_changes(a, b);
  if (!contacts_.is_none() || first_) return;
  for (std::size_t index = 0; index < a.size(); ++index) distance_.add(a[index], b[index]);
  first_ = first_difference(a, b, tolerance_);
}

}  // namespace hyrax

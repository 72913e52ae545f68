#include "sim/compare/trajectory_comparer.h"

#include <algorithm>
#include <cmath>

#include "sim/compare/ulps.h"

namespace hyrax {
namespace {

constexpr std::size_t kContactField = kRowFields.size() - 1;

}  // namespace

bool Tolerance::accepts(double a, double b) const {
  if (std::isnan(a) || std::isnan(b)) return false;
  if (same_bits(a, b)) return true;
  const double difference = std::fabs(a - b);
  if (abs && difference <= *abs) return true;
  if (rel && difference <= *rel * std::max(std::fabs(a), std::fabs(b))) return true;
  return ulps && *ulps_between(a, b) <= static_cast<std::uint64_t>(*ulps);
}

void TrajectoryComparer::compare(const Row& a, const Row& b) {
  for (std::size_t index = 0; index < kRowFields.size(); ++index) {
    const RowField& field = kRowFields[index];
    const double left = field.value(a);
    const double right = field.value(b);
    if (same_bits(left, right) && !std::isnan(left)) continue;
    const double difference = std::fabs(left - right);
    std::optional<WorstDifference>& worst = worst_[index];
    if (!worst || !(difference <= worst->abs)) worst = {a.step, difference, ulps_between(left, right)};
    const bool agrees = index != kContactField && tolerance_.accepts(left, right);
    if (!agrees && !first_)
      first_ = {a.step, std::string(field.name), left, right, ulps_between(left, right)};
  }
}

void TrajectoryComparer::compare(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  contacts_ = contact_changes(a, b);
  if (!contacts_.is_none()) return;
  for (std::size_t index = 0; index < a.size() && !first_; ++index)
    for (const ContactField& field : kContactFields) {
      const double left = a[index].*field.value;
      const double right = b[index].*field.value;
      if (tolerance_.accepts(left, right) || first_) continue;
      first_ = {a[index].step, std::string(field.name), left, right, ulps_between(left, right)};
    }
}

}  // namespace hyrax

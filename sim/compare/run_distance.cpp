#include "sim/compare/run_distance.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string_view>

#include "sim/trajectory/columns.h"

namespace hyrax {
namespace {

constexpr double kRounding_px = 1e-6;
constexpr double kRounding_px_per_s = 1e-6;
constexpr double kRoundingOfSpeed = 1e-12;
constexpr double kRounding_s = 1e-9;

bool is_within(double a, double b, double tolerance) {
  if (same_bits(a, b)) return !std::isnan(a);
  return std::isfinite(a) && std::isfinite(b) && std::fabs(a - b) <= tolerance;
}

bool is_within_rounding(std::string_view unit, double a, double b) {
  if (unit == "s") return is_within(a, b, kRounding_s);
  if (unit == "px") return is_within(a, b, kRounding_px);
  return is_within(a, b, kRounding_px_per_s + kRoundingOfSpeed * std::max(std::fabs(a), std::fabs(b)));
}

bool are_within_rounding(const auto& columns, const auto& a, const auto& b) {
  return std::ranges::all_of(columns, [&](const auto& column) {
    return is_within_rounding(column.unit, *column.number(a), *column.number(b));
  });
}

}  // namespace

double distance_px(const State& a, const State& b) {
  if (same_bits(a.x_px, b.x_px) && same_bits(a.y_px, b.y_px)) return 0.0;
  const double distance = std::hypot(a.x_px - b.x_px, a.y_px - b.y_px);
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

void RunDistance::add(const Row& a, const Row& b) {
  assert(a.step == b.step);
  const int other = (a.contact ^ b.contact) & walls_;
  is_rounding_ = is_rounding_ && other == 0 && are_within_rounding(kRowColumns, a, b);
  has_other_walls_ = has_other_walls_ || (other & ~kRestBit) != 0;
  has_other_dt_ = has_other_dt_ || !same_bits(a.dt_s, b.dt_s);
  take_larger(largest_, {distance_px(state_of(a), state_of(b)), a.step, a.t_s});
}

void RunDistance::add(const Contact& a, const Contact& b) {
  const bool is_unknown = std::isnan(a.overshoot_px) && std::isnan(b.overshoot_px);
  is_rounding_ =
      is_rounding_ &&
      are_within_rounding(kContactQuantities.first(kContactQuantities.size() - (is_unknown ? 1 : 0)), a, b);
}

}  // namespace hyrax

#include "sim/compare/run_distance.h"

#include <algorithm>
#include <cassert>
#include <limits>

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

bool is_time_within(double a_s, double b_s) { return is_within(a_s, b_s, kRounding_s); }
bool is_place_within(double a_px, double b_px) { return is_within(a_px, b_px, kRounding_px); }
bool is_speed_within(double a_px_per_s, double b_px_per_s) {
  const double size_px_per_s = std::max(std::fabs(a_px_per_s), std::fabs(b_px_per_s));
  return is_within(a_px_per_s, b_px_per_s, kRounding_px_per_s + kRoundingOfSpeed * size_px_per_s);
}

bool is_within_rounding(const Row& a, const Row& b) {
  return a.contact == b.contact && is_time_within(a.t_s, b.t_s) && is_time_within(a.dt_s, b.dt_s) &&
         is_place_within(a.x_px, b.x_px) && is_place_within(a.y_px, b.y_px) &&
         is_speed_within(a.vx_px_per_s, b.vx_px_per_s) && is_speed_within(a.vy_px_per_s, b.vy_px_per_s);
}

}  // namespace

double distance_px(const State& a, const State& b) {
  if (same_bits(a.x_px, b.x_px) && same_bits(a.y_px, b.y_px)) return 0.0;
  const double distance = std::hypot(a.x_px - b.x_px, a.y_px - b.y_px);
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

void RunDistance::add(const Row& a, const Row& b) {
  assert(a.step == b.step);
  is_rounding_ = is_rounding_ && is_within_rounding(a, b);
  has_other_walls_ = has_other_walls_ || ((a.contact ^ b.contact) & ~kRestBit) != 0;
  const double px = distance_px(state_of(a), state_of(b));
  if (px > (largest_ ? largest_->px : 0.0)) largest_ = {px, a.step};
}

void RunDistance::add(const Contact& a, const Contact& b) {
  const bool is_unknown = std::isnan(a.overshoot_px) && std::isnan(b.overshoot_px);
  is_rounding_ = is_rounding_ && is_time_within(a.t_s, b.t_s) && is_place_within(a.x_px, b.x_px) &&
                 is_place_within(a.y_px, b.y_px) &&
                 (is_unknown || is_place_within(a.overshoot_px, b.overshoot_px)) &&
                 is_speed_within(a.vx_before_px_per_s, b.vx_before_px_per_s) &&
                 is_speed_within(a.vy_before_px_per_s, b.vy_before_px_per_s) &&
                 is_speed_within(a.vx_after_px_per_s, b.vx_after_px_per_s) &&
                 is_speed_within(a.vy_after_px_per_s, b.vy_after_px_per_s);
}

}  // namespace hyrax

#include "sim/search/step_watch.h"

#include <cmath>
#include <limits>

#include "sim/motion/step.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

// Half a unit in the last place of 1: the largest relative error of one rounded operation.
constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;

double square(double value) { return value * value; }

// 0 for equal bits, else how far off, and never 0.
double minus_difference(double a, double b) {
  if (same_bits(a, b)) return 0.0;
  return -std::max(std::fabs(a - b), std::numeric_limits<double>::denorm_min());
}

}  // namespace

StepWatch::StepWatch(const Core& core, const Scenario& scenario,
                     const std::function<void(std::int64_t)>& report_steps)
    : core_(core),
      report_steps_(report_steps),
      constants_(core.constants.value_or(Constants())),
      inputs_(scenario, inputs_of(scenario, step_count(scenario))) {}

void StepWatch::row(const Row& row) {
  constexpr std::int64_t kStepsBetweenReports = 4096;
  if (report_steps_ && (row.step + 1) % kStepsBetweenReports == 0) report_steps_(row.step);
  check_finite(row);
  speed_before_px_per_s_ = speed_px_per_s_;
  speed_px_per_s_ = std::max(std::fabs(row.vx_px_per_s), std::fabs(row.vy_px_per_s));
  if (has_row_) {
    const InputChange change = inputs_.apply(before_);
    const Bounds bounds = inputs_.bounds();
    if (change.ends_arc || bounds != bounds_ || steps_ == 0) start_from(state_of(before_), bounds);
    if (!inputs_.is_held()) {
      const State from = state_of(before_);
      const Step step{from, core_.constants ? core_.flight(from, row.dt_s) : from, row, bounds};
      ++steps_;
      dt_min_s_ = std::min(dt_min_s_, row.dt_s);
      dt_max_s_ = std::max(dt_max_s_, row.dt_s);
      check_bounds(step);
      if (core_.constants) {
        check_step_energy(step);
        check_energy_ceiling(step);
        check_speed(step);
        check_listing(step);
        check_mirror(step);
        check_no_time(step);
      }
    }
  }
  has_row_ = true;
  before_ = row;
}

void StepWatch::start_from(const State& body, Bounds bounds) {
  bounds_ = bounds;
  steps_ = 0;
  dt_min_s_ = std::numeric_limits<double>::infinity();
  dt_max_s_ = 0.0;
  energy_y_start_px2_per_s2_ = square(body.vy_px_per_s) / 2 +
                               constants_.gravity_px_per_s2 * std::max(0.0, bounds.bottom_px - body.y_px);
  vx_max_px_per_s_ = std::fabs(body.vx_px_per_s);
  vy_max_px_per_s_ = std::fabs(body.vy_px_per_s);
  mirror(body, bounds);
}

// The slack is how many decades the largest number is from overflow. The time rule sums frames with a few
// roundings (sim/scenario/frame_clock.h): a frame that adds less may seem to take some of them back.
void StepWatch::check_finite(const Row& row) {
  const double largest = std::max({std::fabs(row.x_px), std::fabs(row.y_px), std::fabs(row.vx_px_per_s),
                                   std::fabs(row.vy_px_per_s), 1.0});
  const bool is_fine =
      is_finite(state_of(row)) && std::isfinite(row.t_s) && row.t_s >= before_.t_s * (1.0 - 4 * kRounding);
  if (!is_fine) record(Invariant::finite, std::numeric_limits<double>::quiet_NaN(), row.step);
  if (largest <= largest_) return;
  largest_ = largest;
  record(Invariant::finite, std::log10(std::numeric_limits<double>::max()) - std::log10(largest), row.step);
}

// 0 <= x <= right where right >= 0, and the same in y. The slack is minus the distance outside.
void StepWatch::check_bounds(const Step& step) {
  const auto outside_px = [](double at_px, double bound_px) {
    return bound_px >= 0.0 ? std::max({0.0, -at_px, at_px - bound_px}) : 0.0;
  };
  if (step.bounds.right_px < 0 && step.bounds.bottom_px < 0) return;
  record(Invariant::in_bounds,
         -std::max(outside_px(step.row.x_px, step.bounds.right_px),
                   outside_px(step.row.y_px, step.bounds.bottom_px)),
         step.row.step);
}

// With e = (vx^2 + vy^2) / 2 + G (bottom - y), a = air drag <= 1 and u = vy + G h, a flight step gives
// vy' = a u, y' = y + h vy', and so
//   e' - e <= (a^2 - 1) u^2 / 2 + (1 - a) G h u - (G h)^2 / 2,
// which is largest at u = G h / (1 + a): a flight step loses at least a (G h)^2 / (1 + a), whatever its
// speed. (a = 1: exactly (G h)^2 / 2, as symplectic Euler does in a constant field.) How much it loses is the
// listing's own; that it gains nothing holds for any core.
// A clamp turns speeds without raising them, and lifts by y_flight - y, which adds G times that.
// Rounding: vy', vx' have a relative error of at most 3 roundings and y' of 3 in each of its terms; twice
// that covers the two energies.
void StepWatch::check_step_energy(const Step& step) {
  const auto& [from, flight, row, bounds] = step;
  const double gravity = constants_.gravity_px_per_s2;
  const bool is_clamped = flight.y_px < 0.0 || flight.y_px > bounds.bottom_px;
  const double allowed = is_clamped ? gravity * (flight.y_px - row.y_px) : 0.0;
  const double gained = (row.vx_px_per_s - from.vx_px_per_s) * (row.vx_px_per_s + from.vx_px_per_s) / 2 +
                        (row.vy_px_per_s - from.vy_px_per_s) * (row.vy_px_per_s + from.vy_px_per_s) / 2 -
                        gravity * (row.y_px - from.y_px);
  const double size = square(from.vx_px_per_s) + square(from.vy_px_per_s) + square(flight.vy_px_per_s) +
                      square(gravity * row.dt_s) +
                      gravity * (std::fabs(from.y_px) + std::fabs(flight.y_px) + std::fabs(row.y_px));
  record(Invariant::step_energy, allowed - gained + 12 * kRounding * size, row.step);
}

// In y alone, e = vy^2 / 2 + G (bottom - y), and c = restitution < 1 (drag, whenever a core applies it, only
// lowers the speed; a factor above 1 would raise it once a step). Flight and ceiling lower e. A
// step that ends on the ground has at most (c (v + G h))^2 / 2 with v^2 / 2 <= e; and c (v + G h) <= v
// as soon as v >= c G h / (1 - c). So e never exceeds the larger of what it was after the last input and
//   (c G h / (1 - c))^2 / 2, the energy of the residual speed, h the longest frame since.
// With c = 1, no drag and even frames, a bounce from the ground at speed u returns after n frames of which
// n G h is the largest below or at 2 u, and so at most with u; the first one at most with v = G h +
// sqrt((G h)^2 + 2 e), since e + G h vy / 2 does not change in flight, and a clamp adds at most G h v. With
// uneven frames there is no bound. A core of c > 1 must keep to that, too. Rounding adds up over the steps.
void StepWatch::check_energy_ceiling(const Step& step) {
  const double gravity = constants_.gravity_px_per_s2;
  const double c = constants_.restitution * std::max(1.0, constants_.air_drag);
  if (c >= 1.0 && dt_min_s_ != dt_max_s_) return;
  const double pull = gravity * dt_max_s_;
  const double residual_px_per_s =
      c < 1.0 ? c * pull / (1.0 - c) : pull + std::sqrt(square(pull) + 2 * energy_y_start_px2_per_s2_);
  const double ceiling = std::max(energy_y_start_px2_per_s2_, square(residual_px_per_s) / 2);
  const double energy = square(step.row.vy_px_per_s) / 2 + gravity * (step.bounds.bottom_px - step.row.y_px);
  const double rounding = 12 * kRounding * static_cast<double>(steps_ + 1) *
                          (ceiling + gravity * (std::fabs(step.row.y_px) + std::abs(step.bounds.bottom_px)));
  record(Invariant::energy_ceiling, ceiling + rounding - energy, step.row.step);
}

// |vx'| <= a |vx| and |vy'| <= a (|vy| + G h), at a wall too, since no bounce makes faster. So the recurrence
// of a fling that falls freely for ever bounds both, and itself stays below max(|vy|, a G h / (1 - a)),
// terminal speed. Rounding is monotone and symmetric, so this holds to the bit.
void StepWatch::check_speed(const Step& step) {
  const double drag = std::min(constants_.air_drag, 1.0);
  vx_max_px_per_s_ *= drag;
  vy_max_px_per_s_ += constants_.gravity_px_per_s2 * step.row.dt_s;
  vy_max_px_per_s_ *= drag;
  record(Invariant::speed,
         std::min(vx_max_px_per_s_ - std::fabs(step.row.vx_px_per_s),
                  vy_max_px_per_s_ - std::fabs(step.row.vy_px_per_s)),
         step.row.step);
}

// The parametrised step with the core's constants: bounds such as check_speed's also hold for a core that is
// slower than the listing.
void StepWatch::check_listing(const Step& step) {
  State by_listing = step.from;
  ListingStep(constants_, AllParts{}, step.bounds)(by_listing, step.row.dt_s);
  record(Invariant::listing,
         std::min({minus_difference(step.row.x_px, by_listing.x_px),
                   minus_difference(step.row.y_px, by_listing.y_px),
                   minus_difference(step.row.vx_px_per_s, by_listing.vx_px_per_s),
                   minus_difference(step.row.vy_px_per_s, by_listing.vy_px_per_s)}),
         step.row.step);
}

void StepWatch::mirror(const State& body, Bounds bounds) {
  mirrored_ = {bounds.right_px - body.x_px, body.y_px, -body.vx_px_per_s, body.vy_px_per_s};
  mirror_slack_px_ = kRounding * (std::fabs(body.x_px) + std::abs(bounds.right_px));
}

// A second run from right - x with -vx. Every operation on vx is odd, so its vx is -vx to the bit and its y
// and vy are the same bits, as long as both meet the same walls; x differs by the roundings of right - x and
// of x + h vx, which add up until a wall sets both exactly. Where that sum could decide about a wall
// otherwise, it is a knife edge, and the mirrored run starts again.
void StepWatch::check_mirror(const Step& step) {
  const auto& [from, flight, row, bounds] = step;
  mirror_slack_px_ +=
      2 * kRounding *
      (std::fabs(flight.x_px) + std::fabs(flight.vx_px_per_s * row.dt_s) + std::abs(bounds.right_px));
  mirrored_ = core_.step(mirrored_, row.dt_s, bounds);
  const double apart_px = std::fabs(mirrored_.x_px - (bounds.right_px - row.x_px));
  const double apart_px_per_s = std::fabs(mirrored_.vx_px_per_s + row.vx_px_per_s);
  const bool is_same_y =
      same_bits(mirrored_.y_px, row.y_px) && same_bits(mirrored_.vy_px_per_s, row.vy_px_per_s);
  if (is_same_y && apart_px_per_s == 0.0 && apart_px <= mirror_slack_px_) {
    record(Invariant::mirror, mirror_slack_px_ - apart_px, row.step);
    if (flight.x_px < 0.0 || flight.x_px > bounds.right_px) mirror_slack_px_ = 0.0;
    return;
  }
  const double to_wall_px = std::min(std::fabs(flight.x_px), std::fabs(flight.x_px - bounds.right_px));
  if (is_same_y && to_wall_px <= mirror_slack_px_)
    ++knife_edges_;
  else
    record(Invariant::mirror,
           -std::max({apart_px, apart_px_per_s, std::numeric_limits<double>::denorm_min()}), row.step);
  mirror(state_of(row), bounds);
}

// A frame in which no time passes, away from walls.
void StepWatch::check_no_time(const Step& step) {
  const auto& [from, flight, row, bounds] = step;
  const bool is_inside =
      from.x_px >= 0.0 && from.x_px <= bounds.right_px && from.y_px >= 0.0 && from.y_px <= bounds.bottom_px;
  if (row.dt_s != 0.0 || !is_inside) return;
  record(Invariant::no_time,
         -std::max({std::fabs(row.x_px - from.x_px), std::fabs(row.y_px - from.y_px),
                    std::fabs(row.vx_px_per_s - from.vx_px_per_s),
                    std::fabs(row.vy_px_per_s - from.vy_px_per_s)}),
         row.step);
}

}  // namespace hyrax

#include "sim/reference/gsl_flight.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "sim/reference/gsl_driver.h"

namespace hyrax {
namespace {

// The axes in GSL's order; without horizontal motion the first is all.
enum Axis : std::size_t { kY, kX };
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// At a fixed rate GSL flies through so much drag at a time: a single step of rk8pd (order 8) errs by
// 0.06^9 / 9!, 3e-17 of the speed, whatever its own estimate says.
constexpr double kDragPerPiece = 0.06;
// exp(-40) is less than half a unit in the last place: the speed no longer changes.
constexpr double kDragOfAll = 40.0;
constexpr int kBrentTurnsMax = 128;

struct FreeRoot {
  void operator()(gsl_root_fsolver* solver) const { gsl_root_fsolver_free(solver); }
};

// One axis of a flight at a fixed drag rate.
class AxisFlight {
 public:
  explicit AxisFlight(const GslOptions& options)
      : driver_(options, 1), roots_(gsl_root_fsolver_alloc(gsl_root_fsolver_brent)) {
    if (!roots_) throw std::bad_alloc();
  }

  void start(const Approach& approach) { from_ = approach; }

  // NaN where GSL fails.
  [[nodiscard]] AxisMotion after(double t_s) {
    if (t_s == 0.0) return {from_.position_px, from_.speed_px_per_s};
    const double drag_s = std::min(t_s, kDragOfAll / std::fabs(from_.drag_rate_per_s));  // -0 is none.
    const double drag = from_.drag_rate_per_s * drag_s;
    if (!std::isfinite(drag)) return {kNaN, kNaN};
    const int pieces = std::max(1, static_cast<int>(std::ceil(drag / kDragPerPiece)));
    driver_.start(0, {from_.position_px, from_.speed_px_per_s}, from_.acceleration_px_per_s2);
    for (int piece = 0; piece < pieces; ++piece)
      if (!driver_.advance(drag_s / pieces, drag / pieces)) return {kNaN, kNaN};
    AxisMotion end = driver_.at(0);
    end.displacement_px += end.speed_px_per_s * (t_s - drag_s);
    return end;
  }

  // The first outward crossing of 0 within t_s: between two turns of the speed there is one at most.
  [[nodiscard]] std::optional<double> crossing(double t_s) {
    const double turn_s = from_.speed_px_per_s * after(t_s).speed_px_per_s < 0.0
                              ? root(&AxisMotion::speed_px_per_s, 0.0, t_s)
                              : t_s;
    const std::optional<double> before = crossing_between(0.0, turn_s);
    return before || turn_s == t_s ? before : crossing_between(turn_s, t_s);
  }

 private:
  using Value = double AxisMotion::*;
  struct Function {
    AxisFlight* flight;
    Value value;
  };
  static double evaluate(double t_s, void* parameters) {
    const Function& function = *static_cast<const Function*>(parameters);
    return function.flight->after(t_s).*function.value;
  }

  [[nodiscard]] std::optional<double> crossing_between(double low_s, double high_s) {
    const double low_px = after(low_s).displacement_px;
    const double high_px = after(high_s).displacement_px;
    if (std::isnan(low_px + high_px)) return kNaN;
    if (low_px > 0.0 || !(high_px > 0.0)) return std::nullopt;
    return low_px == 0.0 ? low_s : root(&AxisMotion::displacement_px, low_s, high_s);
  }

  // Brent's method. NaN where GSL fails. REQUIRES: the value has another sign at low_s than at high_s.
  [[nodiscard]] double root(Value value, double low_s, double high_s) {
    Function parameters{this, value};
    gsl_function function{evaluate, &parameters};
    gsl_root_fsolver* roots = roots_.get();
    if (gsl_root_fsolver_set(roots, &function, low_s, high_s) != GSL_SUCCESS) return kNaN;
    double t_s = kNaN;
    for (int turn = 0; turn < kBrentTurnsMax; ++turn) {
      if (gsl_root_fsolver_iterate(roots) != GSL_SUCCESS) return kNaN;
      const double last_s = std::exchange(t_s, gsl_root_fsolver_root(roots));
      if (std::fabs(t_s - last_s) <= std::numeric_limits<double>::epsilon() * t_s) break;
    }
    return t_s;
  }

  GslDriver driver_;
  std::unique_ptr<gsl_root_fsolver, FreeRoot> roots_;
  Approach from_;
};

class GslFlight final : public FlightSolver {
 public:
  GslFlight(const GslOptions& options, const Model& model)
      : gravity_px_per_s2_(model.gravity_px_per_s2),
        drag_per_frame_(-std::log(model.air_drag)),
        model_rate_per_s_(drag_per_frame_ * model.model_rate_hz),
        in_y_(options, 1),
        in_both_(options, 2),
        axis_(options) {}

  void start(const Velocity& velocity, bool solves_x) override {
    solves_x_ = solves_x;
    first_ = velocity;
    driver().start(kY, {0.0, velocity.vy_px_per_s}, gravity_px_per_s2_);
    if (solves_x) driver().start(kX, {0.0, velocity.vx_px_per_s}, 0.0);
    has_failed_ = false;
  }

  std::optional<State> advance(double dt_s) override {
    has_failed_ = has_failed_ || !driver().advance(dt_s, drag_per_frame_);
    if (has_failed_) return std::nullopt;
    const AxisMotion y = driver().at(kY);
    const AxisMotion x = solves_x_ ? driver().at(kX) : AxisMotion{};
    return State{x.displacement_px, y.displacement_px, x.speed_px_per_s, y.speed_px_per_s};
  }

  std::optional<Position> model(double t_s) override {
    axis_.start({0.0, first_.vy_px_per_s, gravity_px_per_s2_, model_rate_per_s_});
    const double y_px = axis_.after(t_s).displacement_px;
    axis_.start({0.0, first_.vx_px_per_s, 0.0, model_rate_per_s_});
    const double x_px = solves_x_ ? axis_.after(t_s).displacement_px : 0.0;
    if (std::isnan(x_px + y_px)) return std::nullopt;
    return Position{x_px, y_px};
  }

  std::optional<Impact> time_of_impact(const Approach& approach, double t_max_s) override {
    axis_.start(approach);
    const std::optional<double> t_s = axis_.crossing(t_max_s);
    if (!t_s) return std::nullopt;
    return Impact{*t_s, axis_.after(*t_s).speed_px_per_s, approach.drag_rate_per_s};
  }

 private:
  GslDriver& driver() { return solves_x_ ? in_both_ : in_y_; }

  double gravity_px_per_s2_;
  double drag_per_frame_;
  double model_rate_per_s_;
  GslDriver in_y_;
  GslDriver in_both_;
  AxisFlight axis_;
  Velocity first_;
  bool solves_x_ = true;
  bool has_failed_ = false;
};

}  // namespace

std::unique_ptr<FlightSolver> gsl_flight(const GslOptions& options, const Model& model) {
  assert(options.tolerance >= kGslToleranceMin && options.tolerance <= kGslToleranceMax);
  gsl_set_error_handler_off();
  return std::make_unique<GslFlight>(options, model);
}

}  // namespace hyrax

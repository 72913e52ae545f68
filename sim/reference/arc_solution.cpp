#include "sim/reference/arc_solution.h"

namespace hyrax {

ArcSolution::ArcSolution(const Model& model)
    : gravity_(model.gravity_px_per_s2),
      model_rate_hz_(model.model_rate_hz),
      powers_(FramePowers::of(model)) {
  model_rate_per_s_ = -powers_->log_air_drag() * model_rate_hz_;
}

void ArcSolution::start(const Velocity& velocity, bool solves_x) {
  first_ = velocity;
  solves_x_ = solves_x;
  start_ = {};
  for (WideFlight* const flight : {&start_.discrete, &start_.matched, &start_.exact_law}) {
    flight->x.speed = {velocity.vx_px_per_s, 0.0};
    flight->y.speed = {velocity.vy_px_per_s, 0.0};
  }
  dt_s_ = 0.0;
  frames_ = 0;
  was_at_model_rate_ = true;
}

Position ArcSolution::model_at_other_rates() const {
  const double t_s = elapsed_s();
  const Phi p = phi(-model_rate_per_s_ * t_s);
  return {solves_x_ ? t_s * (first_.vx_px_per_s * p.one) : 0.0,
          t_s * (first_.vy_px_per_s * p.one + gravity_ * t_s * p.two)};
}

void ArcSolution::open_segment(double dt_s) {
  if (frames_ > 0) {
    start_.t = start_.t + two_product(frames(), dt_s_);
    const FramePowers::Forms<DoubleDouble>& powers = powers_->wide(frames_);
    move_on(start_.discrete, powers.discrete);
    move_on(start_.matched, powers.matched);
    move_on(start_.exact_law, powers.exact_law);
    was_at_model_rate_ = was_at_model_rate_ && is_at_model_rate();
    start_.dt_squares = start_.dt_squares + two_product(dt_s_, dt_s_) * frames();
  }
  dt_s_ = dt_s;
  frames_ = 0;
}

void ArcSolution::move_on(WideFlight& flight, const FramePower<DoubleDouble>& power) const {
  const DoubleDouble gain = two_product(gravity_, dt_s_);
  WideAxis& y = flight.y;
  y.displacement = y.displacement + (power.sum * y.speed + gain * power.sum_of_sums) * dt_s_;
  y.speed = power.power * y.speed + gain * power.sum;
  if (!solves_x_) return;
  WideAxis& x = flight.x;
  x.displacement = x.displacement + power.sum * x.speed * dt_s_;
  x.speed = power.power * x.speed;
}

}  // namespace hyrax

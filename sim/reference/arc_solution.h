// One flight arc by the closed forms, frame by frame.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/reference/double_double.h"
#include "sim/reference/flight.h"
#include "sim/reference/model.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// The closed forms are alike. After n frames of dt = h from speed v, with acceleration g,
///   speed = power v + g h sum,   displacement = h (sum v + g h sum_of_sums).
template <class Number>
struct FramePower {
  Number power{};
  Number sum{};
  Number sum_of_sums{};
};

/// Coefficients of the forms for one drag factor a, to 100 bits, and rounded.
///
/// Discrete, what the paper's step does exactly: power = a^n, sum = S_n = a (1 - a^n) / (1 - a),
/// sum_of_sums = a (n - S_n) / (1 - a); by the recurrences S_n+1 = a (1 + S_n) and
/// Q_n+1 = Q_n + S_n+1, which cancel nothing and hold for a = 1 as well.
///
/// Matched, the ODE v' = g - k v with k = -ln(a) / h: z = -k n h = n ln(a), so that
/// power = e^z, sum = n phi1(z), sum_of_sums = n^2 phi2(z) do not depend on h; by the flow of one
/// frame, composed n times.
///
/// Exact law, the ODE whose flow over a frame is the paper's step: v' = kappa g - k v, y' = kappa v + eta
/// with kappa = -a ln(a) / (1 - a) and eta = shift g h, shift = a - kappa^2 phi2(ln a). Over n frames
/// power = e^z, sum = kappa n phi1(z), sum_of_sums = kappa^2 n^2 phi2(z) + shift n, from z and e^z - 1 at
/// once: the flows of single frames, composed, would be the discrete forms whatever phi1 and phi2 were, and
/// a run could not differ from its law. To 75 bits. Source: the modified equation of backward error analysis
/// (E. Hairer, C. Lubich, G. Wanner, "Geometric Numerical Integration", 2nd ed., 2006, chapter IX), for this
/// linear step a closed form.
class FramePowers {
 public:
  /// A longer run of equal frames is cut in pieces of this length.
  static constexpr std::size_t kFramesMax = 128;

  /// REQUIRES: 0.5 <= model.air_drag <= 1.
  explicit FramePowers(const Model& model);
  /// Those of the paper's drag are made once.
  [[nodiscard]] static std::shared_ptr<const FramePowers> of(const Model& model);

  template <class Number>
  struct Forms {
    FramePower<Number> discrete;
    FramePower<Number> matched;
    FramePower<Number> exact_law;
  };
  /// After n frames. REQUIRES: n <= kFramesMax.
  [[nodiscard]] const Forms<double>& rounded(std::size_t n) const { return rounded_[n]; }
  [[nodiscard]] const Forms<DoubleDouble>& wide(std::size_t n) const { return wide_[n]; }

  /// ln(a); the matched drag rate of a frame is -ln(a) / dt.
  [[nodiscard]] double log_air_drag() const { return log_.hi; }
  /// eta / (g h) of the exact law [-]: 1/2 without drag.
  [[nodiscard]] double shift() const { return shift_.hi; }

 private:
  void extend();
  [[nodiscard]] FramePower<DoubleDouble> exact_law_after(double frames, DoubleDouble power) const;
  void push(const Forms<DoubleDouble>& forms);

  double air_drag_;
  DoubleDouble log_;
  DoubleDouble phi1_;  // Of one frame.
  DoubleDouble phi2_;
  DoubleDouble kappa_;
  DoubleDouble kappa_by_log_;  // kappa / ln(a); not for a = 1.
  DoubleDouble shift_;
  std::vector<Forms<double>> rounded_;
  std::vector<Forms<DoubleDouble>> wide_;
};

/// The exact flights that a run is measured against, from one first velocity:
/// - discrete: the paper's step without rounding;
/// - matched: the ODE v' = g - k v whose k is -ln(a) / dt in each frame; a frame of dt 0 only damps;
/// - model: the same ODE with k at its 60 Hz value, whatever the frames are;
/// - exact law: the ODE whose flow is the paper's step (see FramePowers).
///
/// Frames of bit-equal dt are solved from where they began; where dt changes, the state there is
/// kept to 100 bits. So errors do not grow with the number of frames: below 1e-14 of
/// |v| t + g t^2 / 2, and of |v| + g t.
class ArcSolution {
 public:
  explicit ArcSolution(const Model& model);

  /// Begins an arc. Without `solves_x` nothing is computed in x: dx and vx stay 0.
  void start(const Velocity& velocity, bool solves_x);
  /// Flies one frame on. REQUIRES: dt_s >= 0.
  void advance(double dt_s) {
    if (frames_ == FramePowers::kFramesMax || !is_equal(dt_s)) open_segment(dt_s);
    ++frames_;
  }

  /// Since the arc's first row.
  [[nodiscard]] double elapsed_s() const { return start_.t.hi + (frames() * dt_s_ + start_.t.lo); }
  [[nodiscard]] bool solves_x() const { return solves_x_; }

  [[nodiscard]] State discrete() const { return flight(powers_->rounded(frames_).discrete, start_.discrete); }
  [[nodiscard]] State matched() const { return flight(powers_->rounded(frames_).matched, start_.matched); }
  [[nodiscard]] State exact_law() const {
    return flight(powers_->rounded(frames_).exact_law, start_.exact_law);
  }
  /// What the discretisation of gravity did to the energy since the arc's first row, px^2/s^2: along the
  /// exact law de/dt = -k v^2 - g eta, so it is -sum of g eta_i dt_i over the frames, whatever the speed.
  [[nodiscard]] double gravity_energy_px2_per_s2() const {
    const double dt_squares = start_.dt_squares.hi + (frames() * (dt_s_ * dt_s_) + start_.dt_squares.lo);
    return -gravity_ * gravity_ * powers_->shift() * dt_squares;
  }
  /// Displacement alone; of its speeds nothing is asked. The matched ODE's where all frames of the arc had
  /// the model's rate.
  [[nodiscard]] Position model() const {
    if (!was_at_model_rate_ || !is_at_model_rate()) return model_at_other_rates();
    const State same = matched();
    return {same.x_px, same.y_px};
  }

  /// ln(a); the matched drag rate of a frame is -ln(a) / dt.
  [[nodiscard]] double log_air_drag() const { return powers_->log_air_drag(); }

 private:
  struct WideAxis {
    DoubleDouble displacement;
    DoubleDouble speed;
  };
  struct WideFlight {
    WideAxis x;
    WideAxis y;
  };
  // Where the run of equal frames began.
  struct Segment {
    DoubleDouble t;
    WideFlight discrete;
    WideFlight matched;
    WideFlight exact_law;
    DoubleDouble dt_squares;  // Sum over the frames before.
  };

  [[nodiscard]] double frames() const { return static_cast<double>(frames_); }
  [[nodiscard]] bool is_equal(double dt_s) const { return same_bits(dt_s, dt_s_); }
  void open_segment(double dt_s);
  [[nodiscard]] bool is_at_model_rate() const { return dt_s_ * model_rate_hz_ == 1.0; }
  [[nodiscard]] Position model_at_other_rates() const;
  void move_on(WideFlight& flight, const FramePower<DoubleDouble>& power) const;

  [[nodiscard]] State flight(const FramePower<double>& power, const WideFlight& from) const {
    State now;
    const double gain = gravity_ * dt_s_;
    now.y_px = from.y.displacement.hi + dt_s_ * (power.sum * from.y.speed.hi + gain * power.sum_of_sums);
    now.vy_px_per_s = power.power * from.y.speed.hi + gain * power.sum;
    if (!solves_x_) return now;
    now.x_px = from.x.displacement.hi + dt_s_ * (power.sum * from.x.speed.hi);
    now.vx_px_per_s = power.power * from.x.speed.hi;
    return now;
  }

  double gravity_;
  double model_rate_hz_;
  double model_rate_per_s_;
  std::shared_ptr<const FramePowers> powers_;
  bool solves_x_ = true;
  Velocity first_;
  Segment start_;
  double dt_s_ = 0.0;
  std::size_t frames_ = 0;
  bool was_at_model_rate_ = true;  // In all frames before the segment.
};

}  // namespace hyrax

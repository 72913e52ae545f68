// A fling by the fixed laws, from impact to impact: the reference that methods are measured against.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/reference/flight.h"
#include "sim/reference/model.h"

namespace hyrax {

/// The fixed ODE: the paper's factors of a frame as rates, taken at the model's 60 Hz.
///
/// Flight: v' = g - k v with k = -60 ln 0.999 = 0.06003 1/s. A wall met at speed v is left at 0.6 v; the
/// ground takes a fifth of vx at every impact, and one after which the speed is below 5 px/s is the last:
/// from then on the sprite slides, vx' = -(k + f) vx with f = -60 ln 0.8 = 13.39 1/s.
struct FixedLaws : Model {
  explicit FixedLaws(const Model& model = {})
      : Model(model),
        drag_rate_per_s((0.0 - std::log(air_drag)) * model_rate_hz),
        friction_rate_per_s((0.0 - std::log(ground_friction)) * model_rate_hz) {}

  double drag_rate_per_s;
  double friction_rate_per_s;  ///< Of a sprite that lies on the ground.
};

struct ExactImpact {
  double t_s = 0.0;  ///< Since the start.
  Wall wall = Wall::ground;
};

/// Whether a sprite that slides goes on sliding from here: on the ground, inside, without vertical speed.
[[nodiscard]] bool slides_on(const State& motion, const Bounds& bounds);

/// Between impacts the closed form of flight.h; each impact is its root (flight.h). Frames play no part.
/// Walls that are met at one time are taken together, in the order of kWalls.
class ExactFling {
 public:
  /// More are not solved for: without losses a fast sprite in a small window never stops meeting walls.
  static constexpr std::size_t kImpactsMax = 1'000'000;

  explicit ExactFling(const FixedLaws& laws = FixedLaws()) : laws_(laws) {}

  /// Starts again at time 0. REQUIRES: bounds of at least 0. A start outside is put onto the wall
  /// that it is behind, as an impact at time 0.
  /// @param slides whether it slid until now; so it slides on where slides_on() holds.
  /// @param until_s no later time will be asked for. Longer than any scenario that is studied by default, and
  /// short enough for the closed form's bracket.
  void start(const State& motion, const Bounds& bounds, bool slides = false, double until_s = 1e4);

  /// Inside the bounds. REQUIRES: t_s not below any asked for before, since the start, and at most until_s.
  [[nodiscard]] State at(double t_s);

  /// Whether each state so far was inside by itself, but for rounding. Where one was not, an impact was
  /// missed: the reference is at fault, and what it says means nothing.
  [[nodiscard]] bool is_sound() const { return is_sound_; }
  /// Whether it met kImpactsMax walls: from there on it stays where it was.
  [[nodiscard]] bool is_cut() const { return impacts_.size() >= kImpactsMax; }
  [[nodiscard]] bool slides() const { return slides_; }
  /// Up to the latest time asked for, in their order; in a corner the wall in x first.
  [[nodiscard]] const std::vector<ExactImpact>& impacts() const { return impacts_; }

 private:
  void find_next();
  void meet_walls();
  void bounce(Wall wall);
  void turn(double& speed_px_per_s) const;
  [[nodiscard]] Approach seen_from(Wall wall) const;
  [[nodiscard]] State fly(double since_s);
  void keep_inside(double& position_px, double far_px);
  [[nodiscard]] double rate_per_s() const {
    return laws_.drag_rate_per_s + (slides_ ? laws_.friction_rate_per_s : 0.0);
  }

  FixedLaws laws_;
  Bounds bounds_;
  State from_;           // State at from_s_,
  double from_s_ = 0.0;  // where this arc or slide began.
  double until_s_ = 0.0;
  double next_s_ = 0.0;  // Time of the next impact, after from_s_.
  Wall next_wall_ = Wall::ground;
  bool slides_ = false;
  bool is_sound_ = true;
  std::vector<ExactImpact> impacts_;
};

}  // namespace hyrax

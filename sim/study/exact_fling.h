// A fling by the fixed laws, from impact to impact: the truth that methods are measured against.
#pragma once

#include <vector>

#include "sim/study/fixed_laws.h"
#include "sim/study/motion.h"
#include "sim/trajectory/wall.h"

namespace hyrax {

struct ExactImpact {
  double t_s = 0.0;  ///< Since the start.
  Wall wall = Wall::ground;
};

/// Between impacts the closed form of flight.h; each impact is its root (impact.h). Frames play no part.
class ExactFling {
 public:
  explicit ExactFling(const FixedLaws& laws = FixedLaws()) : laws_(laws) {}

  /// Begins anew at time 0. REQUIRES: a room that can hold the sprite. A start outside is put onto the wall
  /// that it is behind, as an impact at time 0.
  void start(const Motion& motion, const Room& room);

  /// REQUIRES: t_s not below any asked for before, since the start.
  [[nodiscard]] Motion at(double t_s);

  /// Up to the latest time asked for, in their order; the corner's wall in x first.
  [[nodiscard]] const std::vector<ExactImpact>& impacts() const { return impacts_; }

 private:
  void put_inside();
  void find_next();
  void meet(Wall wall);
  [[nodiscard]] Motion fly(double since_s) const;

  FixedLaws laws_;
  Room room_;
  Motion from_;          // State at from_s_,
  double from_s_ = 0.0;  // where this arc or slide began.
  double next_s_ = 0.0;  // Time of the next impact.
  Wall next_wall_ = Wall::ground;
  bool slides_ = false;
  std::vector<ExactImpact> impacts_;
};

}  // namespace hyrax

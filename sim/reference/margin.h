// How near a run is to being another run.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/reference/model.h"
#include "sim/trajectory/input_playback.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// What a step decides: whether a wall, in the order of kWalls, clamps it, and whether the rest rule stops
/// it.
enum class Decision { left, right, top, ground, rest };

inline constexpr std::array<std::string_view, 5> kDecisionNames = {"left wall", "right wall", "top", "ground",
                                                                   "rest rule"};

/// d(end) / d(start), rows and columns in the order x, y, vx, vy; px, px, px/s, px/s.
using Sensitivity = std::array<std::array<double, 4>, 4>;

/// The decision that is nearest to falling otherwise.
struct NearestDecision {
  Decision decision = Decision::ground;
  std::int64_t step = 0;  ///< Row number.
  bool is_taken = false;  ///< Whether the wall clamped the step, or the rest rule stopped it.
  /// The face of the box through which it falls: from the start, in signs of x, y, vx, vy, 0 where
  /// the decision does not depend on it.
  std::array<double, 4> towards{};
};

struct Margin {
  /// Half-width of the largest box around the start, in px and in px/s alike, within which every
  /// step takes the same branches; none where no decision depends on the start.
  std::optional<double> half_width;
  std::optional<NearestDecision> nearest;
  Sensitivity sensitivity{};
  /// The most that any coordinate of the end moves for a start moved by 1 in all coordinates: the
  /// largest row sum of magnitudes.
  double sensitivity_norm = 0.0;
};

/// One pass over the rows. At given dt and sizes the step is piecewise affine, and the branches it
/// took are in the rows; so what a decision looks at is an affine function of the start, with the
/// Jacobian's row as slope, and falls the same way within |value| / |slope|_1. x and y meet only in
/// the ground's friction, which is a factor, and a speed depends on the start's position through
/// decisions alone, so that the 4 x 4 Jacobian is two triangles of 2 x 2. Exact except for rounding,
/// also of the run itself.
class MarginMeter final : public RowSink {
 public:
  /// @param inputs of the scenario, as they were applied.
  MarginMeter(const Scenario& scenario, std::vector<Input> inputs, const Model& model = {});

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = last_.step < last_decisive_step_ ? 1 : 0};
  }
  /// Rows from row 0 on, every one, live or from a file.
  void row(const Row& row) override;
  void repeats(const Repetition& repetition) override;
  /// Of the rows so far.
  [[nodiscard]] Margin margin() const;

 private:
  // Slope of a quantity of one axis over the start's position and speed along it.
  struct Slope {
    double by_position = 0.0;
    double by_speed = 0.0;
  };
  struct Axis {
    Slope position{1.0, 0.0};
    double speed_by_speed = 1.0;
  };
  // The step before the clamp, along one axis. Position and move are not added: where they are to
  // be compared with a wall, their sum has lost the digits that count.
  struct Unclamped {
    double from_px = 0.0;
    double move_px = 0.0;
    double speed_px_per_s = 0.0;
  };

  void step_to(const Row& row);
  Unclamped fly(Axis& axis, double position_px, double speed_px_per_s, double acceleration_px_per_s2,
                double dt_s) const;
  void decide_walls(const Row& row, Wall near, Wall far, const Axis& axis, const Unclamped& step);
  void clamp(const Row& row, double vy_unclamped_px_per_s);
  void consider(Decision decision, const Row& row, bool is_taken, double value, double sign,
                const Slope& slope);

  InputPlayback playback_;
  Model model_;
  Row last_;  // With the inputs of the next frame.
  bool has_ended_ = false;
  std::int64_t last_decisive_step_ = std::numeric_limits<std::int64_t>::max();
  Axis x_;
  Axis y_;
  double half_width_;
  NearestDecision nearest_;
};

}  // namespace hyrax

// What methods are given to play: a start, bounds, and inputs, at any frame rate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/reference/exact_fling.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A stretch of time whose inputs are all at its beginning.
struct Stage {
  double duration_s = 0.0;  ///< > 0.
  Bounds bounds;
  std::vector<Action> inputs = {};
  std::optional<double> hitch_s = {};  ///< The first frame's own dt; the others share what is left.
  bool is_held = false;                ///< The sprite does not move.
};

struct Problem {
  std::string name;    ///< As a key: "long-arc".
  std::string label;   ///< For readers: "one second in the air".
  std::string remark;  ///< What is left out, as "its first 60 s"; may be empty.
  State start;
  std::vector<Stage> stages;
  std::optional<Jitter> jitter;  ///< A normal one's sigma in units of the frame.
  bool is_free_flight = false;   ///< Meets no wall, has one stage.

  [[nodiscard]] double duration_s() const;
};

/// Longer ones are cut to this: at 7680 Hz it is half a million frames.
inline constexpr double kProblemMax_s = 60.0;

/// Flights that meet nothing, flings with contacts, and clocks out of step. Flights have the room that they
/// need by these laws, flings last until they have settled, and what is thrown into a corner meets it.
[[nodiscard]] std::vector<Problem> study_problems(const FixedLaws& laws);

/// A scenario as a problem: its events at their times, its jitter at every rate; a recorded clock becomes one
/// without jitter. Nothing, and why, where it has no time or no room for its sprite.
struct ScenarioProblem {
  std::optional<Problem> problem;
  std::string why_not;
};
[[nodiscard]] ScenarioProblem problem_of(const Scenario& scenario);

/// dt of every frame of every stage at a rate: each stage is cut into equal frames, as near to the rate as
/// they fit, then jittered.
[[nodiscard]] std::vector<std::vector<double>> stage_frames_s(const Problem& problem, double rate_hz);

}  // namespace hyrax

// Plays members of a sweep, and keeps of each only the numbers that the sweep names.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/scenario/sweep.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

struct KernelSet;

/// What is kept of a member: the bits that a replay of its scenario gives. Fields of a Keep that the sweep
/// does not name are unspecified.
struct MemberResult {
  State final;
  WallCounts contacts;
  double at_rest_since_s = std::numeric_limits<double>::quiet_NaN();  ///< NaN: it has not settled.
  double x_min_px = 0.0;  ///< Extremes are over all rows, the start among them.
  double x_max_px = 0.0;
  double y_min_px = 0.0;
  double y_max_px = 0.0;
  double speed_max_px_per_s = 0.0;
  Digest state_hash{};

  /// Extremes of the start, and of the rows after it: a row replaces one only if it is strictly beyond it.
  /// That of the speed is squared until its owner has taken all rows.
  void begin_extremes(const State& start);
  void include(const State& row);
};

/// Steps that were played, and how many of them were computed in full: in the others the state repeats
/// exactly, or the sprite is on the ground, where all but x and vx repeats.
struct StepTally {
  std::int64_t steps = 0;
  std::int64_t computed = 0;

  StepTally& operator+=(const StepTally& other) {
    steps += other.steps;
    computed += other.computed;
    return *this;
  }
};

/// Plays members of a sweep: those of a core with the paper's step by kernels, those of any other step by
/// step, to the same bits. One a thread.
class EnsemblePlayer {
 public:
  /// Refers to the core and the sweep. @param kernels null: the fastest that this machine can run.
  EnsemblePlayer(const Core& core, const Sweep& sweep, const KernelSet* kernels = nullptr);
  ~EnsemblePlayer();

  /// Plays the members of rows `first_row`, `first_row + 1`, ... of a part, one for each result.
  /// REQUIRES: the rows exist.
  StepTally play(const WorkPart& part, std::int64_t first_row, std::span<MemberResult> results);

 private:
  class Batch;
  Core core_;  // With the base's parameters.
  const Sweep& sweep_;
  std::unique_ptr<Batch> batch_;  // Nothing if the members are replayed.
};

/// Plays one scenario by the replay, step by step: the meaning of every result.
StepTally play_member(const Core& core, const Scenario& scenario, const KeepSet& keep, MemberResult& result);

}  // namespace hyrax

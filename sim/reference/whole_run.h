// The whole run against the exact fling, row by row: how far it ends from where physics would put it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/reference/enclosed_fling.h"
#include "sim/reference/exact_fling.h"
#include "sim/reference/model.h"
#include "sim/trajectory/input_playback.h"
#include "sim/trajectory/resting_contact.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {

/// Why there is no exact fling with these constants, as "gravity is 0"; empty: there is one.
[[nodiscard]] std::string why_no_exact_fling(const Model& model);

/// Distances are hypot(dx, dy) of run and exact fling at the time of a row, energies those of the run minus
/// the exact fling's, as the height that they lift the sprite by. Row 0 is where both begin.
struct WholeRun {
  double end_px = 0.0;
  double max_px = 0.0;
  std::int64_t max_px_step = 0;  ///< The first row of that distance.
  double energy_end_px = 0.0;    ///< Signed.
  /// Magnitudes: the largest before the resting contact, over rows at which run and exact fling have had the
  /// same number of contacts at each wall since the last input that set the velocity; and over all others, in
  /// which one of them has bounced, and the other not yet.
  double energy_max_px = 0.0;
  double energy_phase_px = 0.0;
  std::optional<double> secular_px_per_s;  ///< DriftSummary's.
  /// Bounds of end_px and max_px, against the exact fling of the constants' binary64 values; none where they
  /// were not asked for, or something cannot be decided.
  std::optional<double> end_px_low, end_px_high, max_px_low, max_px_high;
  /// Row of the first contact, counted in order since the last input until the exact fling slides, whose wall
  /// is not that of the exact impact.
  std::optional<std::int64_t> contacts_differ_from;
};

/// A row of the run against the exact fling at its time, as WholeRun.
struct WholeRow {
  double t_s = 0.0;
  double distance_px = 0.0;
};

struct WholeOutcome {
  std::optional<WholeRun> run;
  std::string why_not;        ///< Why there is no exact fling.
  bool is_fault = false;      ///< The reference is at fault: the exact fling left its bounds.
  std::string enclosure_why;  ///< What cannot be decided for the bounds of end_px and max_px.
};

/// Gets every row of a run, live or from a file, and flies the exact fling with the run's inputs and sizes.
/// Between inputs the exact fling goes its own way; a velocity that is set is set for both, a start outside
/// is an impact at time 0, and a sprite that slid on goes on sliding where an input leaves it on the ground
/// without vertical speed.
class WholeMeter final : public RowSink {
 public:
  /// @param inputs of the scenario, as they were applied.
  /// @param each gets every row that is compared, if there is one to call. Where the run repeats itself to
  /// its end, and the exact fling is at rest, later rows are as those before.
  /// @param encloses whether end_px and max_px get bounds: some microseconds a row.
  WholeMeter(const Scenario& scenario, std::vector<Input> inputs, const Model& model = {},
             std::function<void(const WholeRow&)> each = nullptr, bool encloses = false);

  [[nodiscard]] Wants wants() const override { return {.rows_every = is_over_ ? 0 : 1}; }
  void row(const Row& row) override;
  void repeats(const Repetition& repetition) override { repetition_ = repetition; }
  /// After the last row.
  [[nodiscard]] WholeOutcome finish();

 private:
  void start(const Row& from, const InputChange& change);
  void enclose(const Row& row);
  void compare(const Row& row);
  void compare_contacts(const Row& row);
  void compare_energies(const Row& row);
  void settle_energies(bool are_resting);
  void end_stretch();
  void end_without(std::string why, bool is_fault = false);

  InputPlayback playback_;
  FixedLaws laws_;
  ExactFling fling_;
  std::int64_t steps_;
  State exact_;
  double from_s_ = 0.0;  // Time at which the exact fling began, or began again after an input.
  // The exact fling slides on by less than can be measured: from there on it is in its place.
  std::optional<std::int64_t> still_from_step_;
  struct Met {
    std::int64_t step = 0;
    Wall wall = Wall::ground;
  };
  std::vector<Met> met_;  // The run's contacts since from_s_,
  std::size_t compared_ = 0;
  std::uint8_t contact_before_ = 0;
  WallCounts ahead_;         // How many more contacts the run has had than the exact fling,
  std::size_t counted_ = 0;  // of whose impacts so many are counted.
  Row last_;
  RestingContact resting_;
  double open_energy_max_px_ = 0.0;
  std::optional<Repetition> repetition_;
  bool is_over_ = false;
  std::function<void(const WholeRow&)> each_;
  std::optional<EnclosedFling> enclosed_;
  EnclosedState within_;  // The exact state at the last row.
  WholeOutcome outcome_;
};

}  // namespace hyrax

// A scenario through the exact physics::update, frame by frame, into a sink.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/row_sink.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {

struct ReplayOptions {
  /// Stop computing where the state repeats exactly at a fixed dt; the results are the same.
  bool skips_repetition = true;
  bool checks_bounds = false;  ///< Fills RunSummary::out_of_bounds_step.
};

/// Plays a scenario in constant memory. Rows, contacts, blocks and the whole summary are the same bits
/// however the run is cut into calls of play_to; only how many equal blocks are handed on at once may
/// differ. Skipping repetition changes nothing but steps_computed.
class Replay {
 public:
  /// From the start. Row 0 goes to the sink at once. Refers to scenario and sink.
  /// REQUIRES: a scenario within the limits of scenario.h whose events have frames.
  Replay(const Scenario& scenario, RowSink& sink, ReplayOptions options = {});
  /// Resumes after the keyframe's row, which the sink does not get again. Contacts that touch
  /// there go on uncounted; state_hash, at_rest_since_s and the search for repetition begin at the
  /// keyframe's row: periodic_from_step is never before it, and is that row if the whole run repeats
  /// there already.
  Replay(const Scenario& scenario, const Keyframe& from, RowSink& sink, ReplayOptions options = {});
  ~Replay();
  Replay(Replay&&) noexcept;

  [[nodiscard]] std::int64_t steps() const;
  [[nodiscard]] const Keyframe& keyframe() const;

  /// Plays until row `step` stands, or the state became non-finite. REQUIRES: step <= steps().
  void play_to(std::int64_t step);
  /// Ends the run where it stands: hands on what is left, and sums up.
  RunSummary finish();

 private:
  class Player;
  std::unique_ptr<Player> player_;
};

/// Plays all of a scenario.
RunSummary replay(const Scenario& scenario, RowSink& sink, ReplayOptions options = {});

}  // namespace hyrax

// A scenario through the exact step of a core, frame by frame, into any number of sinks.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/core/core.h"
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
/// however the run is cut into calls of play_to; only how many equal blocks a sink gets at once may
/// differ. Skipping repetition changes nothing but steps_computed.
class Replay {
 public:
  /// From the start. Refers to scenario and sinks.
  /// REQUIRES: a scenario within the limits of scenario.h whose events have frames.
  Replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks = {},
         ReplayOptions options = {});
  Replay(const Core& core, const Scenario& scenario, RowSink& sink, ReplayOptions options = {})
      : Replay(core, scenario, std::vector<RowSink*>{&sink}, options) {}
  /// Resumes after the keyframe's row, which the sink does not get again. Contacts that touch
  /// there go on uncounted; state_hash, at_rest_since_s and the search for repetition begin at the
  /// keyframe's row.
  Replay(const Core& core, const Scenario& scenario, const Keyframe& from, RowSink& sink,
         ReplayOptions options = {});
  ~Replay();
  Replay(Replay&&) noexcept;

  [[nodiscard]] std::int64_t steps() const;
  [[nodiscard]] const Keyframe& keyframe() const;

  /// Plays up to row `step`, or until the state became non-finite. REQUIRES: step <= steps().
  void play_to(std::int64_t step);
  /// Ends the run at its present row: passes on what is left, and sums up.
  RunSummary finish();

 private:
  class Player;
  std::unique_ptr<Player> player_;
};

/// Plays all of a scenario; without sinks for its summary alone.
RunSummary replay(const Core& core, const Scenario& scenario, RowSink& sink, ReplayOptions options = {});
RunSummary replay(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks = {},
                  ReplayOptions options = {});

}  // namespace hyrax

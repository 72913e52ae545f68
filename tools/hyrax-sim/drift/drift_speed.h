// What a step costs, and what half the frame would cost and gain.
#pragma once

#include <optional>
#include <string>

#include "sim/reference/drift.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// Time of one physics::update in ns, over the scenario's first frames without its events: the least of
/// some rounds, a few ms in all. Of this machine, at this moment. None without frames.
[[nodiscard]] std::optional<double> step_ns(const Scenario& scenario);

/// The same scenario at half the dt: twice the frames, its events where they were.
struct HalfDt {
  std::int64_t steps = 0;
  double step_ns = 0.0;
  DriftSummary summary;
  std::optional<ArcErrors> longest_arc;
};
struct HalfDtOutcome {
  std::optional<HalfDt> half;
  std::string why_not;  ///< Where there is none.
};
[[nodiscard]] HalfDtOutcome measure_half_dt(const Scenario& scenario);

}  // namespace hyrax

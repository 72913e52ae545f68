// A run measured against the reference.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/gsl_flight.h"
#include "sim/reference/margin.h"
#include "tools/hyrax-sim/runs/run_rows.h"
#include "tools/report/drift_figures.h"

namespace hyrax {

/// A run lists no more arcs and no more contacts than this; all of them are measured and counted.
inline constexpr std::size_t kArcsListedMax = 100'000;
/// A picture needs no more rows than this; of a longer run every K-th is kept.
inline constexpr std::size_t kRowsDrawnMax = 4'000;

struct DriftOptions {
  std::optional<GslOptions> gsl;  ///< A second solution of every arc; none: the closed form alone.
  bool keeps_rows = false;        ///< For a picture.
  DriftSink* also = nullptr;      ///< Gets all that is measured, too, its rows if it wants them.
};

struct DriftRun {
  Scenario scenario;
  std::int64_t steps = 0;
  double simulated_s = 0.0;
  std::string note;  ///< Of the rows' origin.
  std::optional<GslOptions> gsl;

  DriftSummary summary;
  std::optional<ArcErrors> longest_arc;
  std::vector<ArcErrors> arcs;
  std::vector<ImpactErrors> contacts;
  std::vector<DrawnRow> rows;  ///< On request, thinned out.
  Margin margin;
};

/// Measures every arc and contact, and the margin. Of a run that repeats itself without an arc to its
/// end only the beginning is played.
[[nodiscard]] DriftRun measure_drift(const RunRows& rows, const DriftOptions& options = {});

/// The same by the closed form alone, and nothing kept.
[[nodiscard]] DriftSummary summarize_drift(const RunRows& rows);

/// The margin alone.
[[nodiscard]] Margin margin_of(const RunRows& rows);

}  // namespace hyrax

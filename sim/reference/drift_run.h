// A run measured against the reference, as it is handed on to tables, text, files and figures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/reference/drift.h"
#include "sim/reference/margin.h"
#include "sim/reference/model.h"
#include "sim/reference/whole_run.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// A row, and the number of the arc that it belongs to.
struct DrawnRow {
  std::size_t arc = 0;
  RowErrors errors;
};

struct DriftRun {
  Scenario scenario;
  std::int64_t steps = 0;
  double simulated_s = 0.0;
  std::string note;        ///< On the origin of the rows; may be empty.
  std::string checked_by;  ///< The second solution of every arc: "GSL rk8pd, tolerance 1e-12"; empty: none.
  bool is_checked_by_default = true;  ///< If not, a difference is the second solution's.
  Model model;

  DriftSummary summary;
  std::optional<ArcErrors> longest_arc;
  std::vector<ArcErrors> arcs;            ///< The first of them,
  std::vector<ImpactErrors> contacts;     ///< as these.
  std::vector<DrawnRow> rows = {};        ///< For figures: all or every K-th row of the arcs,
  std::vector<WholeRow> whole_rows = {};  ///< and of the whole run.
  Margin margin;
  WholeOutcome whole;
};

}  // namespace hyrax

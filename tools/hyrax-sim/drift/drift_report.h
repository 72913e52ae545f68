// A run against the reference in words and in JSON.
#pragma once

#include <optional>
#include <string>

#include "tools/files/json.h"
#include "tools/hyrax-sim/drift/drift_run.h"
#include "tools/hyrax-sim/drift/drift_speed.h"

namespace hyrax {

/// What stands beside the errors themselves.
struct DriftReport {
  DriftRun run;
  bool has_rows_stored = false;  ///< The errors of every row are in a file.
  std::optional<double> step_ns = {};
  HalfDtOutcome half_dt = {};
};

/// A table of at most 100 columns: arcs, contacts, margin, what was left out, and in its last line, where
/// a step was timed, speed against error.
[[nodiscard]] std::string drift_text(const DriftReport& report);

/// The members of an entry of "runs", all but "scenario".
[[nodiscard]] Json::Object drift_json(const DriftReport& report);

/// What was not computed, in words.
[[nodiscard]] std::vector<std::string> left_out(const DriftReport& report);

/// Whether the run as it is and at half the dt show that the error against the fixed model does not
/// vanish with the frame.
[[nodiscard]] bool shows_no_convergence(const DriftReport& report);

}  // namespace hyrax

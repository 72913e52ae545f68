// One run that differs: is it the step, or what the step is fed?
#pragma once

#include <optional>
#include <vector>

#include "sim/explain/cause.h"
#include "sim/explain/explain.h"
#include "sim/explain/observed_step.h"
#include "sim/replay/kernel.h"

namespace hyrax {

struct Diagnosis {
  /// Set where it is not the step, or the cause cannot be determined; else candidates for the step are tried.
  std::optional<Cause> cause;
  /// Steps of the run; those that the listing does not give come first.
  std::vector<ObservedStep> evidence;
  bool has_equal_rows = false;  ///< Only what is measured of the contacts differs.
};

/// @param program the core that played the run.
[[nodiscard]] Diagnosis diagnose(const DifferingRun& run, const Kernel& program);

/// Kind unknown: the first operation whose result differs, if the evidence determines it; input, where only
/// steps after inputs differ.
[[nodiscard]] Cause unexplained(const DifferingRun& run, const std::vector<ObservedStep>& evidence);

}  // namespace hyrax

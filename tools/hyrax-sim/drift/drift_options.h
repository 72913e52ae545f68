// Which solutions a run is measured against, as the command line says it.
#pragma once

#include <optional>
#include <string>

#include "sim/reference/drift.h"
#include "sim/reference/gsl_flight.h"
#include "tools/hyrax-sim/command_line/options.h"

namespace hyrax {

struct ReferenceRequest {
  std::string name;  ///< "closed" or "gsl"; what it is at first is the default.
  std::string stepper;
  std::optional<double> tolerance;

  /// Whether the command line says anything of it, beside a default of "closed".
  [[nodiscard]] bool is_given() const { return name != "closed" || !stepper.empty() || tolerance; }
};

/// --reference, --stepper and --tolerance.
void declare_reference(Options& options, ReferenceRequest& request);

/// None where GSL is not to be entered.
/// ERRORS: Failure(bad_input) "COMMAND: ..." for a tolerance out of range, or settings of GSL without it.
[[nodiscard]] std::optional<GslOptions> gsl_options(const ReferenceRequest& request,
                                                    const std::string& command);

/// How a measurement ends: a fault of the reference is the program's own.
[[nodiscard]] ExitCode drift_exit_code(const DriftSummary& summary);

}  // namespace hyrax

#include "tools/hyrax-sim/drift/drift_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace hyrax {

void declare_reference(Options& options, ReferenceRequest& request) {
  options.choice(request.name,
                 {"--reference", "closed|gsl",
                  "the closed form alone, or GSL beside it as its check; " + request.name + " if left out"},
                 {"closed", "gsl"});
  options.choice(request.stepper, {"--stepper", "NAME", "of GSL; rk8pd if left out"},
                 {kGslStepperNames.begin(), kGslStepperNames.end()});
  options.number(request.tolerance,
                 {"--tolerance", "X", "of GSL's steps, absolute and relative; 1e-12 if left out"},
                 kGslToleranceMin);
}

std::optional<GslOptions> gsl_options(const ReferenceRequest& request, const std::string& command) {
  if (request.name != "gsl") {
    if (!request.stepper.empty() || request.tolerance)
      throw Failure(ExitCode::bad_input,
                    command + ": --stepper and --tolerance are GSL's; add --reference gsl");
    return std::nullopt;
  }
  GslOptions options;
  if (!request.stepper.empty()) {
    const auto name = std::find(kGslStepperNames.begin(), kGslStepperNames.end(), request.stepper);
    options.stepper = static_cast<GslStepper>(name - kGslStepperNames.begin());
  }
  options.tolerance = request.tolerance.value_or(options.tolerance);
  if (options.tolerance > kGslToleranceMax)
    throw Failure(ExitCode::bad_input, fmt::format("{}: --tolerance: must be at most {:g}, is {:g}", command,
                                                   kGslToleranceMax, options.tolerance));
  return options;
}

ExitCode drift_exit_code(const DriftSummary& summary) {
  if (summary.reference_faults > 0) return ExitCode::program_fault;
  return summary.non_finite_step ? ExitCode::disagreed : ExitCode::agreed;
}

}  // namespace hyrax

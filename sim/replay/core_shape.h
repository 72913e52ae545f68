// Whether this program's core is the paper's step with constants of its own.
#pragma once

#include <optional>

#include "sim/trace/listing_step.h"

namespace hyrax {

/// By the trace of its step that the build recorded. Of a step that is not known `difference` says why.
[[nodiscard]] const StepShape& core_shape();

/// The constants by which runs of this core are measured as the paper's model: those of the shipped class,
/// whatever its step, or of another core of the same shape. Nothing: they cannot be.
[[nodiscard]] std::optional<Constants> measured_constants();

}  // namespace hyrax

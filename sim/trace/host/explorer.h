// All paths through the functions of a core that is compiled with recording numbers.
#pragma once

#include "sim/trace/host/core_calls.h"
#include "sim/trace/host/number.h"

namespace hyrax {
struct TracedStep;
}

namespace hyrax::trace {

using TracedCore = CoreCalls<Real, Whole>;

/// The step as recorded, not canonical. A step that is not complete ends in stop().
[[nodiscard]] TracedStep trace_core(const TracedCore& core);

/// The host's main program: `PROGRAM STEP_FILE WHY_FILE [HEADER COMPILED TRACED SYMBOLS]` writes the
/// canonical text of the step, or why it is not complete. @param arguments the last four as the files of
/// HeaderOutput (allowed.h), which are looked at before the core is called.
int record_main(const TracedCore& core, int argument_count, char** arguments);

}  // namespace hyrax::trace

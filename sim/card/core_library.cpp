// A core as a library: compiled once for each header, with a folder first in the include path whose
// sim/physics/physics.h is that header.
#include "sim/card/core_defect.h"
#include "sim/card/core_functions.h"
#include "sim/replay/core.cpp"  // NOLINT(bugprone-suspicious-include): one unit, as one command compiles it.
#include "sim/replay/kernel.cpp"  // NOLINT(bugprone-suspicious-include): as above.

extern "C" [[gnu::visibility("default")]] const hyrax::CoreFunctions* hyrax_core_functions() {
  static const hyrax::CoreFunctions functions{.kernel = &hyrax::core_kernel(),
                                              .model = hyrax::core_model,
                                              .step = hyrax::core_step,
                                              .steps = hyrax::core_steps,
                                              .played = hyrax::core_played,
                                              .stopped = hyrax::core_stopped,
                                              .flight = hyrax::core_flight,
                                              .is_listing = hyrax::core_is_listing,
                                              .defect = hyrax::defect_of<physics>};
  return &functions;
}

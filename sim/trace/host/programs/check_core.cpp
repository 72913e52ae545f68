// Compiles the header HYRAX_CORE_HEADER as it is, and holds it to its traced step: see record_core.cmake.
#include "sim/motion/state.h"
#include "sim/trace/host/compiled_core.h"

template <class Physics>
int hyrax_check_core(int argument_count, char** arguments) {
  using namespace hyrax::trace;
  std::optional<hyrax::Constants> constants;
  if constexpr (hyrax::HasPaperConstants<Physics>) constants = hyrax::constants_of<Physics>();
  return check_main(calls_of<Physics, double, int>(), constants, argument_count, arguments);
}

#include HYRAX_CORE_HEADER

int main(int argument_count, char** arguments) {
  return hyrax_check_core<physics>(argument_count, arguments);
}

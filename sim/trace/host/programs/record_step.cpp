// Compiles the header HYRAX_CORE_HEADER with numbers that record, and writes its step: see record_core.cmake.
//
// HYRAX_CORE_PRELUDE includes the standard headers that it includes: they are compiled with usual numbers.
// From the header on no name is used that its macros might have, too.
#include HYRAX_CORE_PRELUDE

#include "sim/trace/host/explorer.h"
#include "sim/trace/host/number_functions.h"

using hyrax_traced_double = hyrax::trace::Real;
using hyrax_traced_float = hyrax::trace::Single;
using hyrax_traced_int = hyrax::trace::Whole;
using hyrax_traced_bool = hyrax::trace::Truth;

template <class Physics>
int hyrax_record_step(int argument_count, char** arguments) {
  using namespace hyrax::trace;
  return record_main(calls_of<Physics, Real, Whole>(), argument_count, arguments);
}

#define double hyrax_traced_double
#define float hyrax_traced_float
#define int hyrax_traced_int
#ifdef HYRAX_TRACES_BOOL
#define bool hyrax_traced_bool
#endif
#include HYRAX_CORE_HEADER
#undef double
#undef float
#undef int
#undef bool

int main(int argument_count, char** arguments) {
  return hyrax_record_step<physics>(argument_count, arguments);
}

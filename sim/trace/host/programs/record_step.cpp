// Compiles the header HYRAX_CORE_HEADER with numbers that record, and writes its step: see record_core.cmake.
// HYRAX_DESCRIBED_NAME: it is that of a core that describes itself.
//
// HYRAX_CORE_PRELUDE includes the standard headers that it includes: they are compiled with usual numbers.
// From the header on no name is used that its macros might have, too.
#include HYRAX_CORE_PRELUDE

#include "sim/trace/host/number_functions.h"
#ifdef HYRAX_DESCRIBED_NAME
#include "sim/described/traced_description.h"
#else
#include "sim/trace/host/explorer.h"
#endif

using hyrax_traced_double = hyrax::trace::Real;
using hyrax_traced_float = hyrax::trace::Single;
using hyrax_traced_int = hyrax::trace::Whole;
using hyrax_traced_bool = hyrax::trace::Truth;

template <class Core>
int hyrax_record_step(int argument_count, char** arguments) {
  using namespace hyrax::trace;
#ifdef HYRAX_DESCRIBED_NAME
  return record_main(hyrax::see::traced_calls_of<Core>(), argument_count, arguments);
#else
  return record_main(calls_of<Core, Real, Whole>(), argument_count, arguments);
#endif
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

#ifdef HYRAX_DESCRIBED_NAME
#define HYRAX_CORE hyrax_core
#else
#define HYRAX_CORE physics
#endif
int main(int argument_count, char** arguments) {
  return hyrax_record_step<HYRAX_CORE>(argument_count, arguments);
}

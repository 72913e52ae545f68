// Compiles the header HYRAX_CORE_HEADER with numbers that record, and writes its step: see record_core.cmake.
// HYRAX_DESCRIBED_NAME: it is that of a core that describes itself.
//
// HYRAX_CORE_PRELUDE includes the standard headers that it includes: they are compiled with usual numbers.
// From the header on no name is used that its macros might have, too.
#include HYRAX_CORE_PRELUDE

#include "sim/trace/host/number_functions.h"
#ifdef HYRAX_DESCRIBED_NAME
#include "sim/described/traced_description.h"
#define HYRAX_CORE hyrax_core
#define HYRAX_CALLS(Core) hyrax::see::traced_calls_of<Core>()
#else
#include "sim/trace/host/explorer.h"
#define HYRAX_CORE physics
#define HYRAX_CALLS(Core) hyrax::trace::calls_of<Core, hyrax::trace::Real, hyrax::trace::Whole>()
#endif

using hyrax_traced_double = hyrax::trace::Real;
using hyrax_traced_float = hyrax::trace::Single;
using hyrax_traced_int = hyrax::trace::Whole;
using hyrax_traced_bool = hyrax::trace::Truth;

template <class Core>
int hyrax_record_step(int argument_count, char** arguments) {
  return hyrax::trace::record_main(HYRAX_CALLS(Core), argument_count, arguments);
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
  return hyrax_record_step<HYRAX_CORE>(argument_count, arguments);
}

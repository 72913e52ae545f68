#include "tools/described/program.h"
#include "tools/files/build_info.h"

#ifdef HYRAX_OWN_PROGRAM  // Of tools/own_core.
#include "own_flags.h"
#endif

// It is linked with an object of this program, which is built without.
#if defined(HYRAX_OWN_PROGRAM) && defined(_GLIBCXX_DEBUG)
#error \
    "hyrax: -D_GLIBCXX_DEBUG gives containers another layout than hyrax-sim is built with; build without it"
#endif

int main(int argc, char** argv) {
#ifdef HYRAX_OWN_PROGRAM
  hyrax::set_core_build(kOwnFlags, hyrax::compiler_here(), hyrax::instruction_set_here());
#endif
  return hyrax::run_described_program(hyrax::built_described_core, argc, argv);
}

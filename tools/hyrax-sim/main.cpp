#include "sim/core/shipped_core.h"
#include "tools/hyrax-sim/program.h"

int main(int argc, char** argv) { return hyrax::run_hyrax_sim(hyrax::shipped_core(), argc, argv); }

// The program that hyrax_add_scenarios.cmake builds: hyrax-sim with a core of one's own.
// sim/physics/physics.h is the user's header, HYRAX_OWN_CORE the core's name.
#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/trajectory/physics_model.h"
#include "tools/hyrax-sim/program.h"

static_assert(!hyrax::is_paper_model(HYRAX_OWN_CORE),
              "hyrax: the name of the paper's model; give the core another");

int main(int argc, char** argv) {
  return hyrax::run_hyrax_sim(hyrax::core_of<physics>(HYRAX_OWN_CORE, hyrax::built_core_record()), argc,
                              argv);
}

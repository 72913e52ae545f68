// In place of sim/reference/gsl_flight.cpp and of GSL itself: whoever enters, falls.
#include <gsl/gsl_version.h>
#include <cstdio>
#include <cstdlib>

#include "sim/reference/gsl_flight.h"

const char* gsl_version = "none";

namespace hyrax {

std::unique_ptr<FlightSolver> gsl_flight(const GslOptions&, const Model&) {
  std::fputs("entered GSL\n", stderr);
  std::_Exit(99);
}

}  // namespace hyrax

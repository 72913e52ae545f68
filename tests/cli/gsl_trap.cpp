// In place of sim/reference/gsl_flight.cpp and of GSL itself: whoever enters, falls.
#include <gsl/gsl_version.h>
#include <cstdio>
#include <cstdlib>

#include "sim/reference/gsl_flight.h"

const char* gsl_version = "none";

namespace hyrax {

struct GslFlight::Solver {};

GslFlight::GslFlight(const GslOptions&, const Model&) {
  std::fputs("entered GSL\n", stderr);
  std::_Exit(99);
}
GslFlight::~GslFlight() = default;
void GslFlight::start(const Velocity&, bool) {}
bool GslFlight::advance(double) { return false; }
Flight GslFlight::flight() const { return {}; }
std::optional<Flight> GslFlight::model(double) { return std::nullopt; }
std::optional<Impact> GslFlight::time_of_impact(const Approach&, double) { return std::nullopt; }
bool GslFlight::is_accurate() const { return false; }

}  // namespace hyrax

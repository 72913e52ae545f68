#include <limits>

#include "sim/result/table.h"
#include "sim/study/rest/rest_map.h"

namespace hyrax {

Table rest_map_table(const std::vector<RateEnds>& map) {
  const auto flings = [&](FinalState state) {
    const auto index = static_cast<std::size_t>(state);
    return column_of<std::int64_t>(std::string(kFinalStateNames[index]), "1",
                                   "flings that ended so: " + std::string(kFinalStateNames[index]), map,
                                   [index](const RateEnds& ends) { return ends.flings[index]; });
  };
  return {"final_states",
          "how random flings end, by display rate",
          {column_of<double>("rate", "Hz", "display rate", map,
                             [](const RateEnds& ends) { return ends.rate_hz; }),
           column_of<double>("gain", "px/s", "speed that a step of gravity gives after drag", map,
                             [](const RateEnds& ends) { return ends.gain_px_per_s; }),
           flings(FinalState::rest), flings(FinalState::cycle), flings(FinalState::buzz),
           flings(FinalState::moving),
           column_of<std::int64_t>("unforeseen", "1", "flings that the boundaries do not allow", map,
                                   [](const RateEnds& ends) { return ends.unforeseen; }),
           column_of<double>("time_low", "s", "time until it lies, first decile", map,
                             [](const RateEnds& ends) { return ends.time_low_s; }),
           column_of<double>("time_median", "s", "time until it lies, median", map,
                             [](const RateEnds& ends) { return ends.time_median_s; }),
           column_of<double>("time_high", "s", "time until it lies, last decile", map,
                             [](const RateEnds& ends) { return ends.time_high_s; })}};
}

Table rest_boundary_table(const std::vector<RestBoundary>& boundaries) {
  return {"boundaries",
          "display rates at which the ways to end change",
          {column_of<std::string>("boundary", "", "what changes", boundaries,
                                  [](const RestBoundary& boundary) { return boundary.name; }),
           column_of<double>("analytic", "Hz", "derived from the constants", boundaries,
                             [](const RestBoundary& boundary) { return boundary.analytic_hz; }),
           column_of<double>("measured", "Hz", "found on the core by bisection", boundaries,
                             [](const RestBoundary& boundary) {
                               return boundary.measured_hz.value_or(std::numeric_limits<double>::quiet_NaN());
                             })}};
}

Table bounce_table(const std::vector<BounceSeen>& bounces) {
  return {"bounces",
          "effective restitution of the first bounce of a drop",
          {column_of<double>("rate", "Hz", "display rate", bounces,
                             [](const BounceSeen& seen) { return seen.rate_hz; }),
           column_of<double>("phase", "1", "part of the contact's step past the floor", bounces,
                             [](const BounceSeen& seen) { return seen.phase; }),
           column_of<double>("restitution", "1", "speed after the contact over speed of the exact impact",
                             bounces, [](const BounceSeen& seen) { return seen.restitution; })}};
}

}  // namespace hyrax

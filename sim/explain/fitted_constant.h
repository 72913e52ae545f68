// Constants that are neither the golden file's nor declared in this program: what the observed steps ask for.
#pragma once

#include <vector>

#include "sim/explain/candidate.h"
#include "sim/explain/observed_step.h"

namespace hyrax {

/// The listing with another number in the place of a constant, at one of the statements that use it or at
/// several. For each such place, the numbers that give the observed steps of a run are an interval; runs
/// whose intervals meet share one candidate, with the shortest decimal in all of them. In order of their
/// decimals' lengths.
/// @param runs the observed steps of each run, those that the listing does not give first.
[[nodiscard]] std::vector<Candidate> fitted_candidates(
    const Constants& golden, const std::vector<const std::vector<ObservedStep>*>& runs);

/// The number of the fewest significant digits in low .. high, both included. REQUIRES: low <= high, finite.
[[nodiscard]] double shortest_decimal(double low, double high);

}  // namespace hyrax

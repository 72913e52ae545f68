// Random scenarios of a core that describes itself.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/described/described_scenario.h"

namespace hyrax {

inline constexpr std::uint64_t kLastAttempt = 10;

/// Run `run` of a seed, the same on every machine: one of these scenarios with other values, times and clock,
/// within all limits of files. Numbers become -8 to 8 times theirs, a 0 up to 100, what has limits or names
/// any of them.
/// @param attempt 0 .. kLastAttempt: another draw, in which each further one gives fewer values of the start,
/// inputs and parameters, the last one none.
/// REQUIRES: at least one scenario, read for the description.
[[nodiscard]] DescribedScenario random_scenario(const Description& description,
                                                const std::vector<DescribedScenario>& library,
                                                std::uint64_t seed, std::uint64_t run,
                                                std::uint64_t attempt = 0);

}  // namespace hyrax

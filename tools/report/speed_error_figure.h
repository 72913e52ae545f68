// The work-precision diagram of one problem.
#pragma once

#include <cstddef>
#include <string>

#include "sim/study/speed_error/speed_error.h"

namespace hyrax {

/// gnuplot's script: error against cost, and beside it error against dt, one line a method, its fitted order
/// in the key, the Pareto front ringed, gaps where a method failed. No error at all is drawn on a
/// line of its own, marked 0.
[[nodiscard]] std::string speed_error_script(const SpeedError& study, std::size_t problem,
                                             const std::string& machine);

/// What drag by the frame does to convergence, in one sentence with the figures of this study.
[[nodiscard]] std::string convergence_sentence(const SpeedError& study);

}  // namespace hyrax

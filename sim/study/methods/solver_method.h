// A FlightSolver of the reference behind the studies' contract.
#pragma once

#include <functional>
#include <memory>

#include "sim/reference/flight_solver.h"
#include "sim/study/methods/method.h"

namespace hyrax {

/// Makes a solver of the matched ODE for one drag factor a frame.
using SolverMaker = std::function<std::unique_ptr<FlightSolver>(const Model&)>;

/// Flies without walls, in frames of 1 / kCheckRate_hz and inside them in steps of its own. The matched ODE
/// of such frames is made the fixed one by the drag factor that they have at the fixed rate.
[[nodiscard]] std::unique_ptr<Method> method_of(const SolverMaker& make_solver);

}  // namespace hyrax

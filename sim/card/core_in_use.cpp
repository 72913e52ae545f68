#include "sim/card/core_in_use.h"

#include <cassert>

#include "sim/replay/core.h"
#include "sim/replay/core_constants.h"

namespace hyrax {
namespace {

const CoreFunctions* current = nullptr;

const CoreFunctions& core() {
  assert(current != nullptr);
  return *current;
}

}  // namespace

CoreInUse::CoreInUse(const CoreFunctions& core) : before_(current) { current = &core; }
CoreInUse::~CoreInUse() { current = before_; }

// All that sim/replay/core.cpp and kernel.cpp define: the linker then takes neither of them.
const Kernel& core_kernel() { return *core().kernel; }
std::string_view core_model() { return core().model(); }
Constants core_constants() { return core().kernel->constants().value(); }
State core_step(const State& body, double dt_s, const Bounds& bounds) {
  return core().step(body, dt_s, bounds);
}
State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps) {
  return core().steps(body, dt_s, bounds, steps);
}
State core_played(const State& body, std::span<const double> frames_s, const Bounds& bounds, int parts) {
  return core().played(body, frames_s, bounds, parts);
}
State core_stopped(const State& body) { return core().stopped(body); }
State core_flight(const State& body, double dt_s) { return core().flight(body, dt_s); }
bool core_is_listing() { return core().is_listing(); }

}  // namespace hyrax

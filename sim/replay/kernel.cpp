#include "sim/motion/paper_constants.h"
#include "sim/physics/physics.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/kernel_of.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

struct ShippedCores {
  using Core = physics;
  static constexpr bool kKeepsObject = sizeof(physics) != sizeof(State);

  [[nodiscard]] physics make(const State& state) const {
    return {state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s};
  }
  [[nodiscard]] Constants constants() const { return constants_of<physics>(); }
  [[nodiscard]] bool is_listing() const { return core_is_listing(); }
};

}  // namespace

const Kernel& compiled_kernel() {
  static const KernelOf<ShippedCores> kernel;
  return kernel;
}

std::string_view core_model() { return kPhysicsModel; }

Constants core_constants() { return *compiled_kernel().constants(); }

}  // namespace hyrax

// In place of sim/replay/kernel.cpp in a program whose class physics is a core of one's own, which
// hyrax_add_scenarios.cmake builds: sim/physics/physics.h is then the user's header, HYRAX_OWN_CORE the
// core's name.
#include <type_traits>

#include "sim/motion/paper_constants.h"
#include "sim/physics/physics.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/core_shape.h"
#include "sim/replay/kernel_of.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

static_assert(!is_paper_model(HYRAX_OWN_CORE), "hyrax: the name of the paper's model; give the core another");
static_assert(std::is_trivially_copyable_v<physics>,
              "hyrax: class physics must be trivially copyable: a run goes on with a copy of it");

struct OwnCores {
  using Core = physics;
  static constexpr bool kKeepsObject = true;

  [[nodiscard]] physics make(const State& state) const {
    return {state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s};
  }
  template <class Physics = physics>
  requires HasPaperConstants<Physics>
  [[nodiscard]] auto listing(const Bounds& bounds) const {
    return ListingStep(constants_of<Physics>(), AllParts{}, bounds);
  }
};

}  // namespace

const Kernel& compiled_kernel() {
  static const KernelOf<OwnCores> kernel;
  return kernel;
}

std::string_view core_model() { return HYRAX_OWN_CORE; }

Constants core_constants() { return core_shape().constants.value(); }

}  // namespace hyrax

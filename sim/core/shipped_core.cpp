#include "sim/core/shipped_core.h"

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {

const Core& shipped_core() {
  static const Core core = core_of<physics>(kPhysicsModel, built_core_record());
  return core;
}

}  // namespace hyrax

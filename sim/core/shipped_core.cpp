#include "sim/core/shipped_core.h"

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/physics/strict_arithmetic.h"  // Refuses flags that change its bits.
#include "sim/trajectory/physics_model.h"

namespace hyrax {

// With a core of one's own in the place of sim/physics/physics.h (tools/own_core), its name.
#ifdef HYRAX_OWN_CORE
constexpr std::string_view kCoreName = HYRAX_OWN_CORE;
static_assert(!is_paper_model(kCoreName), "hyrax: the name of the paper's model; give the core another");
#else
constexpr std::string_view kCoreName = kPhysicsModel;
#endif

const Core& shipped_core() {
  static const Core core = core_of<physics>(kCoreName, built_core_record());
  return core;
}

}  // namespace hyrax

#include "sim/core/shipped_core.h"

#include "sim/core/core_of.h"
#include "sim/physics/physics.h"
#include "sim/physics/strict_arithmetic.h"  // Refuses flags that change its bits.
#include "sim/trajectory/physics_model.h"

// ::physics is this one only if a header of one's own has none.
namespace hyrax_missing {
class physics;
}  // namespace hyrax_missing
using namespace hyrax_missing;

namespace hyrax {

// With a core of one's own in the place of sim/physics/physics.h (tools/own_core), its name.
#ifdef HYRAX_OWN_CORE
constexpr std::string_view kCoreName = HYRAX_OWN_CORE;
static_assert(!is_paper_model(kCoreName), "hyrax: the name of the paper's model; give the core another");
#else
constexpr std::string_view kCoreName = kPhysicsModel;
#endif

static_assert(
    !std::is_same_v<::physics, hyrax_missing::physics>,
    "hyrax: the header has no global class physics; a core that describes itself, struct hyrax_core, "
    "is built by hyrax_add_scenarios(DIR CORE HEADER)");

namespace {

#define HYRAX_NEEDS(call, member)                                                                       \
  static_assert(                                                                                        \
      requires(Class & body, const Class& made) { call; },                                              \
      "hyrax: class physics has no " member                                                             \
      "; to keep your class as it is, write an adapter: class physics { your_class it; public: " member \
      " { /* by it */ } ... }")
// Refuses a class without a member of class physics, in a sentence with the adapter to write.
template <class Class>
consteval void require_members() {
  HYRAX_NEEDS(Class(1.0, 1.0, 1.0, 1.0), "physics(double x, double y, double vx, double vy)");
  HYRAX_NEEDS(body.update(1.0, 1, 1, 1, 1),
              "void update(double dt, int screenWidth, int screenHeight, int objWidth, int objHeight)");
  HYRAX_NEEDS(made.x(), "double x() const");
  HYRAX_NEEDS(made.y(), "double y() const");
  HYRAX_NEEDS(made.vx(), "double vx() const");
  HYRAX_NEEDS(made.vy(), "double vy() const");
  HYRAX_NEEDS(body.setPos(1.0, 1.0), "void setPos(double x, double y)");
  HYRAX_NEEDS(body.setVelocity(1.0, 1.0), "void setVelocity(double vx, double vy)");
  HYRAX_NEEDS(body.resetVelocity(), "void resetVelocity()");
}
#undef HYRAX_NEEDS

}  // namespace

const Core& shipped_core() {
  require_members<::physics>();
  static const Core core = core_of<::physics>(kCoreName, built_core_record());
  return core;
}

}  // namespace hyrax

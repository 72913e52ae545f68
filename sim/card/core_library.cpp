// A core as a library: compiled once for each header, with a folder first in the include path whose
// sim/physics/physics.h is that header.
#include "sim/physics/physics.h"

#include <string>

#include "sim/card/compared_core.h"
#include "sim/card/core_defect.h"
#include "sim/core/core_of.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

template <class Class>
constexpr bool kIsCore = requires(Class body, const Class& constant, double real, int px) {
  Class(real, real, real, real);
  body.update(real, px, px, px, px);
  body.setPos(real, real);
  body.setVelocity(real, real);
  body.resetVelocity();
  constant.x() + constant.y() + constant.vx() + constant.vy();
};
static_assert(kIsCore<physics>,
              "class physics needs a constructor from (x, y, vx, vy), update, setPos, setVelocity, "
              "resetVelocity, and const x, y, vx, vy");

volatile std::int64_t* updates = nullptr;

// Counts each update before it begins: wherever it ends the process, the count is known (PlayWatch).
class CountedCore : public physics {
 public:
  using physics::physics;
  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    *updates = *updates + 1;
    physics::update(dt_s, window_width_px, window_height_px, sprite_width_px, sprite_height_px);
  }
};

}  // namespace
}  // namespace hyrax

extern "C" [[gnu::visibility("default")]] hyrax::LibraryCore* hyrax_library_core(
    volatile std::int64_t* updates) {
  using namespace hyrax;
  hyrax::updates = updates;
  static LibraryCore library{.counted = core_of<CountedCore>(kPhysicsModel, {}),
                             .timed = core_of<physics>(kPhysicsModel, {}),
                             .lacking = lacking_constants<physics>(),
                             .defect = [] { return DefectSearch<CountedCore>().search(); }};
  return &library;
}

// A core as a library: compiled once for each header, with a folder first in the include path whose
// sim/physics/physics.h is that header.
#include "sim/physics/physics.h"

#include <cmath>
#include <concepts>
#include <limits>
#include <string>

#include "sim/card/core_functions.h"

namespace hyrax {
namespace {

template <class Core>
constexpr bool kIsCore = requires(Core body, const Core& constant, double real, int px) {
  Core(real, real, real, real);
  body.update(real, px, px, px, px);
  body.setPos(real, real);
  body.setVelocity(real, real);
  body.resetVelocity();
  constant.x() + constant.y() + constant.vx() + constant.vy();
};
static_assert(kIsCore<physics>,
              "class physics needs a constructor from (x, y, vx, vy), update, setPos, setVelocity, "
              "resetVelocity, and const x, y, vx, vy");

// NaN where the header has no such constant.
#define HYRAX_CONSTANT_OF(NAME)                                      \
  template <class Core>                                              \
  double NAME##_of() {                                               \
    if constexpr (requires {                                         \
                    { *&Core::NAME } -> std::convertible_to<double>; \
                  })                                                 \
      return static_cast<double>(Core::NAME);                        \
    else                                                             \
      return std::numeric_limits<double>::quiet_NaN();               \
  }
HYRAX_CONSTANT_OF(GRAVITY)
HYRAX_CONSTANT_OF(RESTITUTION)
HYRAX_CONSTANT_OF(AIR_DRAG)
HYRAX_CONSTANT_OF(GROUND_FRICTION)
HYRAX_CONSTANT_OF(REST_THRESHOLD)

volatile std::int64_t* updates = nullptr;

// Counts each update before it begins: wherever it ends the process, the count is known (PlayWatch).
class CountedCore : public physics {
 public:
  using physics::physics;
  static inline const double GRAVITY = GRAVITY_of<physics>();
  static inline const double RESTITUTION = RESTITUTION_of<physics>();
  static inline const double AIR_DRAG = AIR_DRAG_of<physics>();
  static inline const double GROUND_FRICTION = GROUND_FRICTION_of<physics>();
  static inline const double REST_THRESHOLD = REST_THRESHOLD_of<physics>();
  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    *updates = *updates + 1;
    physics::update(dt_s, window_width_px, window_height_px, sprite_width_px, sprite_height_px);
  }
};

const char* lacking_constants() {
  static const std::string names = [] {
    std::string text;
    for (const auto& [name, value] : {std::pair("GRAVITY", CountedCore::GRAVITY),
                                      {"RESTITUTION", CountedCore::RESTITUTION},
                                      {"AIR_DRAG", CountedCore::AIR_DRAG},
                                      {"GROUND_FRICTION", CountedCore::GROUND_FRICTION},
                                      {"REST_THRESHOLD", CountedCore::REST_THRESHOLD}})
      if (std::isnan(value)) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }();
  return names.empty() ? nullptr : names.c_str();
}

// As core_steps, uncounted: to be timed.
State timed_steps(const State& body, double dt_s, const Bounds& bounds, std::int64_t steps) {
  physics moving(body.x_px, body.y_px, body.vx_px_per_s, body.vy_px_per_s);
  const int right_px = static_cast<int>(bounds.right_px);
  const int bottom_px = static_cast<int>(bounds.bottom_px);
  for (std::int64_t step = 0; step < steps; ++step) moving.update(dt_s, right_px, bottom_px, 0, 0);
  return {moving.x(), moving.y(), moving.vx(), moving.vy()};
}

}  // namespace
}  // namespace hyrax

// What follows is compiled for the core that counts.
#define physics CountedCore
#include "sim/card/core_defect.h"
#include "sim/replay/core.cpp"  // NOLINT(bugprone-suspicious-include): one unit, as one command compiles it.

#include "sim/replay/kernel.cpp"  // NOLINT(bugprone-suspicious-include): as above.

// It plays every step, and looks for none to skip.
bool hyrax::core_is_listing() { return false; }

extern "C" [[gnu::visibility("default")]] const hyrax::CoreFunctions* hyrax_core_functions(
    int number, volatile std::int64_t* updates) {
  hyrax::updates = updates;
  static const hyrax::CoreFunctions functions{.number = number,
                                              .kernel = &hyrax::compiled_kernel(),
                                              .model = hyrax::core_model,
                                              .step = hyrax::core_step,
                                              .steps = hyrax::core_steps,
                                              .timed_steps = hyrax::timed_steps,
                                              .played = hyrax::core_played,
                                              .stopped = hyrax::core_stopped,
                                              .flight = hyrax::core_flight,
                                              .lacking = hyrax::lacking_constants,
                                              .defect = hyrax::defect_of<hyrax::CountedCore>};
  return &functions;
}

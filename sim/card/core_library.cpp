// A core as a library: compiled once for each header, with a folder first in the include path whose
// sim/physics/physics.h is that header.
#include "sim/physics/physics.h"

#include "sim/card/core_functions.h"

namespace hyrax {
namespace {

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

// A kernel that plays every step: it looks for none to skip by steps that belong to no run.
namespace hyrax {
namespace {
bool skips_steps() { return false; }
}  // namespace
}  // namespace hyrax
#define core_is_listing skips_steps
#include "sim/replay/kernel.cpp"  // NOLINT(bugprone-suspicious-include): as above.
#undef core_is_listing

extern "C" [[gnu::visibility("default")]] const hyrax::CoreFunctions* hyrax_core_functions(
    int number, volatile std::int64_t* updates) {
  hyrax::updates = updates;
  static const hyrax::CoreFunctions functions{.number = number,
                                              .kernel = &hyrax::core_kernel(),
                                              .model = hyrax::core_model,
                                              .step = hyrax::core_step,
                                              .steps = hyrax::core_steps,
                                              .timed_steps = hyrax::timed_steps,
                                              .played = hyrax::core_played,
                                              .stopped = hyrax::core_stopped,
                                              .flight = hyrax::core_flight,
                                              .is_listing = hyrax::core_is_listing,
                                              .defect = hyrax::defect_of<hyrax::CountedCore>};
  return &functions;
}

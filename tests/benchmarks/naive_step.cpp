#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {

void naive_step(physics& body, double dt_s, Size window) {
  body.update(dt_s, window.width_px, window.height_px, kSprite_px, kSprite_px);
}

}  // namespace hyrax::bench

#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {

void naive_step(physics& body, double dt, int screen_width, int screen_height, int obj_width,
                int obj_height) {
  body.update(dt, screen_width, screen_height, obj_width, obj_height);
}

}  // namespace hyrax::bench

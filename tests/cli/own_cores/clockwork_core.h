// Sub-steps of 1/240 s by an accumulator, which is state.
#pragma once

struct hyrax_core {
  double angle = 0.25, speed = 0, left = 0;

  void step(double dt_s) {
    constexpr double kStep = 1.0 / 240;
    left += dt_s;
    for (; left >= kStep; left -= kStep) {
      speed -= 30 * angle * kStep;
      angle += speed * kStep;
    }
  }
  void state(auto&& see) {
    see("angle_rad", angle);
    see("speed_rad_per_s", speed);
    see("left_s", left);
  }
};

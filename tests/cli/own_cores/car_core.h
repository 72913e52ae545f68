// A car from above: friction, and a gear that is a plain enum with a number below 0.
#pragma once

#include <cstdint>

enum gear_kind : std::int8_t { reverse = -1, neutral, first, second };

struct hyrax_core {
  double x = 400, y = 300, heading_x = 1, heading_y = 0, speed = 0;
  gear_kind gear = first;
  double steer = 0, throttle = 0;
  double friction = 0.4;

  void step(double dt_s) {
    speed += throttle * 120 * gear * dt_s;
    speed -= friction * speed * dt_s;
    const double turn = steer * dt_s, old_x = heading_x;
    heading_x -= turn * heading_y;
    heading_y += turn * old_x;
    x += heading_x * speed * dt_s;
    y += heading_y * speed * dt_s;
    if (gear == first && speed > 90) gear = second;
  }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("y_px", y);
    see("heading.x", heading_x);
    see("heading.y", heading_y);
    see("speed_px_per_s", speed);
    see("gear", gear, {reverse, second});
  }
  template <class See>
  void inputs(See&& see) {
    see("steer", steer, {-1, 1});
    see("throttle", throttle, {0, 1});
  }
  template <class See>
  void parameters(See&& see) {
    see("friction", friction);
  }
  template <class See>
  void properties(See&& see) const {
    see.sometimes("changes gear", gear == second);
  }
};

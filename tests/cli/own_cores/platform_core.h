// A float world: a platform that an input moves, and a jump for one press, which the step takes.
#pragma once

struct hyrax_core {
  float x = 40, y = 0, vy = 0, platform_x = 50;
  float move = 0;
  bool jump = false, on_ground = true;
  float gravity = 1800;

  void step(double dt_s) {
    const float dt = static_cast<float>(dt_s);
    platform_x += move * 200 * dt;
    if (jump && on_ground) vy = -700;
    jump = false;
    vy += gravity * dt;
    y += vy * dt;
    on_ground = y >= 0;
    if (on_ground) y = 0, vy = 0, x += move * 200 * dt;
  }
  void state(auto&& see) {
    see("player_x_px", x);
    see("player_y_px", y);
    see("vy_px_per_s", vy);
    see("platform_x_px", platform_x);
    see("on_ground", on_ground);
  }
  void inputs(auto&& see) {
    see("move", move, {-1, 1});
    see("jump", jump);
  }
  void parameters(auto&& see) { see("gravity_px_per_s2", gravity); }
  void contacts(auto&& see) const { see("ground", on_ground); }
};

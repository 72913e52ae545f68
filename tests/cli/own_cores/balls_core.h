// Two balls that collide, in a box; they are structs with a list of their own.
#pragma once

#include <cmath>

struct ball {
  double x = 0, y = 0, vx = 0, vy = 0;
  void state(auto&& see) {
    see("x_px", x);
    see("y_px", y);
    see("vx_px_per_s", vx);
    see("vy_px_per_s", vy);
  }
};

struct hyrax_core {
  ball a{100, 100, 300, 40}, b{300, 110, 0, 0};
  double width = 800, height = 600;
  double radius = 20, restitution = 0.9;
  bool rail = false, balls = false;

  void step(double dt_s) {
    rail = balls = false;
    ball* both[] = {&a, &b};
    for (ball* p : both) {
      p->x += p->vx * dt_s;
      p->y += p->vy * dt_s;
      if ((p->x < radius && p->vx < 0) || (p->x > width - radius && p->vx > 0)) p->vx = -p->vx, rail = true;
      if ((p->y < radius && p->vy < 0) || (p->y > height - radius && p->vy > 0)) p->vy = -p->vy, rail = true;
    }
    const double dx = b.x - a.x, dy = b.y - a.y, d = std::sqrt(dx * dx + dy * dy);
    if (d >= 2 * radius || d <= 0) return;
    const double nx = dx / d, ny = dy / d, closing = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny;
    if (closing <= 0) return;
    const double j = 0.5 * (1 + restitution) * closing;
    a.vx -= j * nx;
    a.vy -= j * ny;
    b.vx += j * nx;
    b.vy += j * ny;
    balls = true;
  }

  void state(auto&& see) {
    see("a", a);
    see("b", b);
  }
  void inputs(auto&& see) {
    see("width_px", width, {320.0, 4096.0});
    see("height_px", height);
  }
  void parameters(auto&& see) {
    see("restitution", restitution, {0, 1});
    see("radius_px", radius);
  }
  void actions(auto&& see) {
    see("strike", [&](double vx, double vy) { a.vx = vx, a.vy = vy; }, {"vx_px_per_s", "vy_px_per_s"});
    see("stop", [&] { a.vx = a.vy = b.vx = b.vy = 0; });
  }
  void contacts(auto&& see) const {
    see("rail", rail);
    see("balls", balls);
  }
  void outputs(auto&& see) const {
    see("distance_px", std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)));
  }
  void properties(auto&& see) const {
    see.always("the balls stay in the box", a.x > 0 && a.x < width && b.x > 0 && b.x < width);
    see.sometimes("the balls meet", balls);
  }
};

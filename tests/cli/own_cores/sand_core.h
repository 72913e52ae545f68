// Particles in a vector.
#pragma once

#include <vector>

struct grain {
  double x = 0, y = 0, vy = 0;
  bool lies = false;
};

struct hyrax_core {
  std::vector<grain> grains = {{10, 0, 0, false}, {20, 5, 0, false}, {30, 9, -20, false}};
  std::vector<bool> seen = {false, false, false};

  void step(double dt_s) {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      grain& g = grains[i];
      if (g.lies) continue;
      g.vy += 100 * dt_s;
      g.y += g.vy * dt_s;
      if (g.y > 50) g.y = 50, g.lies = true, seen[i] = true;
    }
  }
  void state(auto&& see) {
    see("grains", grains, [](auto& part, grain& g) {
      part("x_px", g.x);
      part("y_px", g.y);
      part("vy_px_per_s", g.vy);
      part("lies", g.lies);
    });
    see("seen", seen);
  }
  void contacts(auto&& see) const { see("first_lies", grains[0].lies); }
};

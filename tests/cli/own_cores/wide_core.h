// 500 values.
#pragma once

#include <array>

struct hyrax_core {
  std::array<std::array<double, 2>, 250> cells = {};

  void step(double dt_s) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (double& value : cells[i]) value += dt_s * static_cast<double>(i);
  }
  void state(auto&& see) { see("cells_px", cells); }
};

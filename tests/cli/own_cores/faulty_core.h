// Runs that end early, and one that is another the second time.
#pragma once

#include <limits>
#include <stdexcept>

enum class fault_kind { none, step_throws, property_throws, nan, first_run };

struct hyrax_core {
  double x = 0;
  fault_kind fault = fault_kind::none;

  void step(double dt_s) {
    static int calls = 0;
    const bool is_late = x > 0.5;
    x += dt_s;
    if (fault == fault_kind::first_run && ++calls > 400) x += 1;
    if (fault == fault_kind::step_throws && is_late) throw std::runtime_error("out of fuel");
    if (fault == fault_kind::nan && is_late) x = std::numeric_limits<double>::quiet_NaN();
  }
  void state(auto&& see) { see("x_px", x); }
  void parameters(auto&& see) {
    see("fault", fault, {"none", "step_throws", "property_throws", "nan", "first_run"});
  }
  void properties(auto&& see) const {
    see.always("x is small",
               fault != fault_kind::property_throws || x < 0.5 || (throw std::logic_error("lost"), true));
  }
};

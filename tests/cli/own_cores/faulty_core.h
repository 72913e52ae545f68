// Faults of a description, one by one.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

enum class fault_kind {
  none,
  forgotten,
  timer,
  rounding,
  static_state,
  first_run,
  pointer,
  step_throws,
  property_throws,
  nan
};

struct hyrax_core {
  std::vector<double> xs = {0, 0};
  double* chosen = xs.data();
  fault_kind fault = fault_kind::none;
  double hidden = 0;
  int frame = 0;

  void step(double dt_s) {
    static int calls = 0;
    ++frame;
    hidden += dt_s;
    double change = dt_s;
    switch (fault) {
      case fault_kind::forgotten:
        change += hidden;
        break;
      case fault_kind::timer:
        change += frame > 300 ? 1 : 0;
        break;
      case fault_kind::static_state:
        change += ++calls % 7;
        break;
      case fault_kind::first_run:
        change += ++calls > 400 ? 1 : 0;
        break;
      case fault_kind::pointer:
        *chosen += 1;
        break;
      case fault_kind::step_throws:
        if (xs[0] > 0.5) throw std::runtime_error("out of fuel");
        break;
      case fault_kind::nan:
        if (xs[0] > 0.5) change = std::numeric_limits<double>::quiet_NaN();
        break;
      default:
        break;
    }
    xs[0] += change;
  }
  template <class See>
  void state(See&& see) {
    see(
        "x_px", [&] { return xs[0]; },
        [&](double x) { xs[0] = fault == fault_kind::rounding ? std::round(x) : x; });
    see("y_px", xs[1]);
  }
  template <class See>
  void parameters(See&& see) {
    see("fault", fault,
        {"none", "forgotten", "timer", "rounding", "static", "first_run", "pointer", "step_throws",
         "property_throws", "nan"});
  }
  template <class See>
  void properties(See&& see) const {
    see.always("x is small",
               fault != fault_kind::property_throws || xs[0] < 0.5 || (throw std::logic_error("lost"), true));
  }
};

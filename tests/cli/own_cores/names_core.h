// Names that cannot be.
#pragma once

struct hyrax_core {
  double x = 0;
  bool on = false;

  void step(double dt_s) { x += dt_s; }
  template <class See>
  void state(See&& see) {
    see("x_px", x);
    see("x_px", x);
    see("t", x);
    see("Speed", x);
    see("limited", x, {1.0, 2.0});
  }
  template <class See>
  void actions(See&& see) {
    see("hold", [&] { x = 0; });
  }
  template <class See>
  void contacts(See&& see) const {
    see("x_px", on);
  }
};

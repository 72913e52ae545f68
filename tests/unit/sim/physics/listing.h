// The paper's listing once more, written from the paper's page and not from the core: the
// independent copy that physics::update is compared with.
//
// Source: "Use of physics in hyrax.exe", section 6.
#pragma once

namespace hyrax {

/// One line of the listing, written wrong on purpose: the controls of the comparison.
enum class Slip {
  none,
  drag_before_gravity,
  position_before_velocity,
  fused_gravity,
  drag_one_ulp_low,
  left_not_strict,
  right_not_strict,
  top_not_strict,
  ground_not_strict,
  y_before_x,
  friction_left_out,
  rest_not_strict,
  rest_without_fabs,
};

/// The body as the listing moves it.
template <Slip kSlip = Slip::none>
struct ListingBody {
  double x;
  double y;
  double vx;
  double vy;

  void update(double dt, int screen_w, int screen_h, int obj_w, int obj_h) {
    if (kSlip == Slip::position_before_velocity) move(dt);
    if (kSlip == Slip::drag_before_gravity) drag();
    if (kSlip == Slip::fused_gravity)
      vy = __builtin_fma(1200.0, dt, vy);
    else
      vy = vy + 1200.0 * dt;
    if (kSlip != Slip::drag_before_gravity) drag();
    if (kSlip != Slip::position_before_velocity) move(dt);

    const double right = screen_w - obj_w;
    const double bottom = screen_h - obj_h;
    if (kSlip == Slip::y_before_x) collide_in_y(bottom);
    collide_in_x(right);
    if (kSlip != Slip::y_before_x) collide_in_y(bottom);
  }

 private:
  void drag() {
    constexpr double kDrag = kSlip == Slip::drag_one_ulp_low ? 0.999 - 0x1p-53 : 0.999;
    vx = vx * kDrag;
    vy = vy * kDrag;
  }

  void move(double dt) {
    x = x + vx * dt;
    y = y + vy * dt;
  }

  void collide_in_x(double right) {
    if (kSlip == Slip::left_not_strict ? x <= 0.0 : x < 0.0) {
      x = 0.0;
      vx = -vx * 0.6;
    } else if (kSlip == Slip::right_not_strict ? x >= right : x > right) {
      x = right;
      vx = -vx * 0.6;
    }
  }

  void collide_in_y(double bottom) {
    if (kSlip == Slip::top_not_strict ? y <= 0.0 : y < 0.0) {
      y = 0.0;
      vy = -vy * 0.6;
    } else if (kSlip == Slip::ground_not_strict ? y >= bottom : y > bottom) {
      y = bottom;
      vy = -vy * 0.6;
      if (kSlip != Slip::friction_left_out) vx = vx * 0.8;
      if (is_resting()) vy = 0.0;
    }
  }

  // |vy| < 5, without the library's fabs, whose sign handling is part of what is compared.
  bool is_resting() const {
    if (kSlip == Slip::rest_without_fabs) return vy < 5.0;
    if (kSlip == Slip::rest_not_strict) return -5.0 <= vy && vy <= 5.0;
    return -5.0 < vy && vy < 5.0;
  }
};

}  // namespace hyrax

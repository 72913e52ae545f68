// A pet that is thrown: spin by getter and setter, a counter of bounces, a pose by name.
#pragma once

enum class pose_kind : unsigned char { sit, fly, land };

class pet {
 public:
  double x = 200, y = 100, vx = 150, vy = 0;
  unsigned bounces = 0;
  pose_kind pose = pose_kind::sit;

  double spin() const { return m_spin; }
  void set_spin(double spin) { m_spin = spin; }
  bool touches_floor() const { return m_touches_floor; }
  void tick(double dt, double gravity, double floor) {
    vy += gravity * dt;
    x += vx * dt;
    y += vy * dt;
    vx += m_spin * dt;
    m_spin *= 0.99;
    m_touches_floor = y > floor;
    pose = m_touches_floor ? pose_kind::land : pose_kind::fly;
    if (!m_touches_floor) return;
    y = floor;
    vy = -vy * 0.6;
    m_spin = -m_spin;
    ++bounces;
  }

 private:
  double m_spin = 3.0;
  bool m_touches_floor = false;
};

struct hyrax_core {
  pet p;
  double gravity = 1200, floor = 500;

  void step(double dt_s) { p.tick(dt_s, gravity, floor); }
  void state(auto&& see) {
    see("x_px", p.x);
    see("y_px", p.y);
    see("vx_px_per_s", p.vx);
    see("vy_px_per_s", p.vy);
    see(
        "spin_rad_per_s", [&] { return p.spin(); }, [&](double spin) { p.set_spin(spin); });
    see("bounces", p.bounces);
    see("pose", p.pose, {"sit", "fly", "land"});
  }
  void parameters(auto&& see) {
    see("gravity_px_per_s2", gravity);
    see("floor_px", floor);
  }
  void actions(auto&& see) {
    see("fling", [&](double vx, double vy) { p.vx = vx, p.vy = vy; }, {"vx_px_per_s", "vy_px_per_s"});
  }
  void contacts(auto&& see) const { see("floor", p.touches_floor()); }
};

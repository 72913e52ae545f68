// Steps that tests write as C++, recorded by the numbers that a core's header is compiled with.
#pragma once

#include <functional>

#include "sim/physics/physics.h"
#include "sim/trace/host/explorer.h"
#include "sim/trace/host/number_functions.h"
#include "sim/trace/step_text.h"

namespace hyrax::recording {

using trace::Real;
using trace::Single;
using trace::Whole;

inline Real to_real(const Whole& a) { return a; }
inline Real to_real(const Single& a) { return a; }
inline Single to_single(const Real& a) { return a; }
inline Whole to_whole(const Real& a) { return a; }

/// A body and what a frame gives it.
struct Body {
  Real x, y, vx, vy;
};
struct Frame {
  Real dt;
  Whole window_width, window_height, sprite_width, sprite_height;
};

template <class AnyBody>
using UpdateOf = std::function<void(AnyBody&, const Frame&)>;
using Update = UpdateOf<Body>;

/// What is traced: an update, with the paper's constructor and setters.
/// @tparam AnyBody a Body, perhaps with further members.
template <class AnyBody>
class Core {
 public:
  static inline const UpdateOf<AnyBody>* recorded = nullptr;

  Core(Real x, Real y, Real vx, Real vy) {
    setPos(x, y);
    setVelocity(vx, vy);
  }
  void update(Real dt, Whole window_width, Whole window_height, Whole sprite_width, Whole sprite_height) {
    (*recorded)(body_, {dt, window_width, window_height, sprite_width, sprite_height});
  }
  [[nodiscard]] Real x() const { return body_.x; }
  [[nodiscard]] Real y() const { return body_.y; }
  [[nodiscard]] Real vx() const { return body_.vx; }
  [[nodiscard]] Real vy() const { return body_.vy; }
  void setPos(Real x, Real y) { body_.x = x, body_.y = y; }
  void setVelocity(Real vx, Real vy) { body_.vx = vx, body_.vy = vy; }
  void resetVelocity() { setVelocity(0.0, 0.0); }

 private:
  AnyBody body_;
};

/// Not canonical.
template <class AnyBody>
TracedStep record_of(const UpdateOf<AnyBody>& update) {
  Core<AnyBody>::recorded = &update;
  return trace::trace_core(trace::calls_of<Core<AnyBody>, Real, Whole>());
}
inline TracedStep record(const Update& update) { return record_of(update); }

/// The listing, with places at which a test changes it.
struct Listing {
  Real gravity = physics::GRAVITY, restitution = physics::RESTITUTION, drag = physics::AIR_DRAG,
       friction = physics::GROUND_FRICTION, threshold = physics::REST_THRESHOLD;
  std::function<void(Body&, const Frame&)> before_drag, before_move, before_walls, at_end;
  std::function<bool(const Body&, const Frame&)> extra_right, extra_ground;

  void operator()(Body& body, const Frame& frame) const {
    body.vy = body.vy + gravity * frame.dt;
    if (before_drag) before_drag(body, frame);
    body.vx = body.vx * drag;
    body.vy = body.vy * drag;
    if (before_move) before_move(body, frame);
    body.x = body.x + body.vx * frame.dt;
    body.y = body.y + body.vy * frame.dt;
    if (before_walls) before_walls(body, frame);
    const Real right = to_real(frame.window_width - frame.sprite_width);
    const Real bottom = to_real(frame.window_height - frame.sprite_height);
    if (body.x < 0.0) {
      body.x = 0.0;
      body.vx = -body.vx * restitution;
    } else if (body.x > right && (!extra_right || extra_right(body, frame))) {
      body.x = right;
      body.vx = -body.vx * restitution;
    }
    if (body.y < 0.0) {
      body.y = 0.0;
      body.vy = -body.vy * restitution;
    } else if (body.y > bottom) {
      body.y = bottom;
      body.vy = -body.vy * restitution;
      body.vx = body.vx * friction;
      if (fabs(body.vy) < threshold && (!extra_ground || extra_ground(body, frame))) body.vy = 0.0;
    }
    if (at_end) at_end(body, frame);
  }
};

/// The listing of the paper.
inline TracedStep record_listing() { return record(Listing()); }

}  // namespace hyrax::recording

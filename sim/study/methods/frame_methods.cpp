#include <algorithm>
#include <cmath>

#include "sim/core/core.h"
#include "sim/motion/step.h"
#include "sim/reference/flight.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/methods/method.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

// A method that plays the motion on from where it is, within bounds.
struct MotionMethod : Method {
  explicit MotionMethod(const Core& moving) : core(moving) {}
  void start(const State& motion, const Bounds& bounds, bool /*goes_on*/) override {
    at = motion;
    within = bounds;
  }
  [[nodiscard]] State motion() const final { return at; }

  const Core& core;
  State at;
  Bounds within;
};

// physics::update as it is, in `kParts` equal parts of a frame.
template <int kParts>
class PaperStep final : public MotionMethod {
 public:
  using MotionMethod::MotionMethod;
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    at = core.played(at, frames_s, within, kParts);
    return true;
  }
};

// --- One frame of free flight each. `prepare` is called whenever dt changes.

struct FrameFlight {
  FixedLaws laws;
  double frame_s = -1.0;  // Not prepared.

  void prepare(double dt_s) { frame_s = dt_s; }
};

// The paper's order of operations, its drag by time: alpha^(60 dt). First order.
struct NormalisedFlight : FrameFlight {
  void prepare(double dt_s) {
    frame_s = dt_s;
    damping = std::exp(-laws.drag_rate_per_s * dt_s);
  }
  void fly(State& m) const {
    m.vy_px_per_s += laws.gravity_px_per_s2 * frame_s;
    m.vx_px_per_s *= damping;
    m.vy_px_per_s *= damping;
    m.x_px += m.vx_px_per_s * frame_s;
    m.y_px += m.vy_px_per_s * frame_s;
  }

  double damping = 1.0;
};

// Explicit Euler: position and velocity both by the rates at the frame's beginning. First order.
struct EulerFlight : FrameFlight {
  void fly(State& m) const {
    m.x_px += m.vx_px_per_s * frame_s;
    m.y_px += m.vy_px_per_s * frame_s;
    m.vx_px_per_s += -laws.drag_rate_per_s * m.vx_px_per_s * frame_s;
    m.vy_px_per_s += (laws.gravity_px_per_s2 - laws.drag_rate_per_s * m.vy_px_per_s) * frame_s;
  }
};

// Velocity Verlet with linear drag taken implicitly in the second half, and so without iteration. Second
// order. Source: L. Verlet, Phys. Rev. 159:98, 1967, in the velocity form of W. C. Swope et al., J. Chem.
// Phys. 76:637, 1982.
struct VerletFlight : FrameFlight {
  void prepare(double dt_s) {
    half_s = 0.5 * dt_s;
    frame_s = dt_s;
    implicit = 1.0 / (1.0 + laws.drag_rate_per_s * half_s);
  }
  void fly(State& m) const {
    const double half_vx = m.vx_px_per_s - half_s * laws.drag_rate_per_s * m.vx_px_per_s;
    const double half_vy =
        m.vy_px_per_s + half_s * (laws.gravity_px_per_s2 - laws.drag_rate_per_s * m.vy_px_per_s);
    m.x_px += frame_s * half_vx;
    m.y_px += frame_s * half_vy;
    m.vx_px_per_s = half_vx * implicit;
    m.vy_px_per_s = (half_vy + half_s * laws.gravity_px_per_s2) * implicit;
  }

  double half_s = 0.0;
  double implicit = 1.0;
};

// The classical Runge-Kutta method. Fourth order. Source: W. Kutta, Z. Math. Phys. 46:435-453, 1901.
struct Rk4Flight : FrameFlight {
  void fly(State& m) const {
    const State k1 = rates(m);
    const State k2 = rates(ahead(m, k1, 0.5 * frame_s));
    const State k3 = rates(ahead(m, k2, 0.5 * frame_s));
    const State k4 = rates(ahead(m, k3, frame_s));
    const auto mean = [](double a, double b, double c, double d) { return (a + 2.0 * (b + c) + d) / 6.0; };
    const State slope{mean(k1.x_px, k2.x_px, k3.x_px, k4.x_px), mean(k1.y_px, k2.y_px, k3.y_px, k4.y_px),
                      mean(k1.vx_px_per_s, k2.vx_px_per_s, k3.vx_px_per_s, k4.vx_px_per_s),
                      mean(k1.vy_px_per_s, k2.vy_px_per_s, k3.vy_px_per_s, k4.vy_px_per_s)};
    m = ahead(m, slope, frame_s);
  }

 private:
  [[nodiscard]] State rates(const State& m) const {
    return {m.vx_px_per_s, m.vy_px_per_s, -laws.drag_rate_per_s * m.vx_px_per_s,
            laws.gravity_px_per_s2 - laws.drag_rate_per_s * m.vy_px_per_s};
  }
  [[nodiscard]] static State ahead(const State& m, const State& rate, double dt_s) {
    return {m.x_px + dt_s * rate.x_px, m.y_px + dt_s * rate.y_px, m.vx_px_per_s + dt_s * rate.vx_px_per_s,
            m.vy_px_per_s + dt_s * rate.vy_px_per_s};
  }
};

// The closed form of flight.h over one frame: the flow itself.
struct ExactFlight : FrameFlight {
  void prepare(double dt_s) {
    frame_s = dt_s;
    const double z = -laws.drag_rate_per_s * dt_s;
    const Phi p = phi(z);
    damping = 1.0 + z * p.one;
    reach_s = dt_s * p.one;
    gain_px_per_s = laws.gravity_px_per_s2 * dt_s * p.one;
    fall_px = laws.gravity_px_per_s2 * dt_s * dt_s * p.two;
  }
  void fly(State& m) const {
    m.x_px += m.vx_px_per_s * reach_s;
    m.y_px += m.vy_px_per_s * reach_s + fall_px;
    m.vx_px_per_s *= damping;
    m.vy_px_per_s = m.vy_px_per_s * damping + gain_px_per_s;
  }

  double damping = 1.0;
  double reach_s = 0.0;
  double gain_px_per_s = 0.0;
  double fall_px = 0.0;
};

// A flight frame by frame, and after each the walls, as the paper's step has them, with one exception: the
// friction of a sprite on the ground is taken by time.
template <class Flight>
class FrameMethod final : public MotionMethod {
 public:
  using MotionMethod::MotionMethod;
  void start(const State& motion, const Bounds& bounds, bool goes_on) override {
    // No input has thrown it since: its vertical speed is 0, or as the last stage left it.
    lies_ = goes_on && lies_ && motion.y_px == bounds.bottom_px &&
            (motion.vy_px_per_s == 0.0 || motion.vy_px_per_s == at.vy_px_per_s);
    MotionMethod::start(motion, bounds, goes_on);
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    State m = at;
    Flight flight{{laws_}};
    double lying_friction = 1.0;
    bool lies = lies_;
    const ListingStep walls(
        Constants{.restitution = laws_.restitution, .rest_threshold_px_per_s = laws_.rest_threshold_px_per_s},
        AllBut<ModelPart::friction>{}, within);
    for (const double frame_s : frames_s) {
      if (frame_s != flight.frame_s) {
        flight.prepare(frame_s);
        lying_friction = std::exp(-laws_.friction_rate_per_s * frame_s);
      }
      flight.fly(m);
      walls.meet_walls_in_x(m);
      const bool lay = lies;
      // A frame too short to move it leaves it lying.
      lies = touches(walls.meet_walls_in_y(m), Wall::ground) || (lay && m.y_px == within.bottom_px);
      if (lies) m.vx_px_per_s *= lay ? lying_friction : laws_.ground_friction;
    }
    at = m;
    lies_ = lies;
    return true;
  }

 private:
  FixedLaws laws_{reference_model(core)};
  bool lies_ = false;  // The last frame touched the ground.
};

// The exact flight of each frame, and where it meets a wall, the impacts inside the frame: at their exact
// times, or swept, where the straight way of the frame meets the wall.
template <bool kIsSwept>
class ImpactsInFrame final : public MotionMethod {
 public:
  using MotionMethod::MotionMethod;
  void start(const State& motion, const Bounds& bounds, bool goes_on) override {
    MotionMethod::start(motion, bounds, goes_on);
    slides_ = goes_on && slides_ && slides_on(motion, bounds);
    t_s_ = 0.0;
    impacts_.clear();
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    ExactFlight flight{{laws_}};
    ExactFlight slide{{sliding_}};
    const Bounds bounds = within;
    State m = at;
    bool slides = slides_;
    double t_s = t_s_;
    for (const double frame_s : frames_s) {
      if (frame_s != flight.frame_s) {
        flight.prepare(frame_s);
        slide.prepare(frame_s);
      }
      State next = m;
      (slides ? slide : flight).fly(next);
      if (is_free(m, next, frame_s, bounds)) {
        m = next;
      } else {
        m = kIsSwept ? with_swept_impacts(m, t_s, frame_s) : with_impacts(m, t_s, frame_s);
        slides = slides_;
      }
      t_s += frame_s;
    }
    at = m;
    t_s_ = t_s;
    return true;
  }
  [[nodiscard]] const std::vector<ExactImpact>* impacts() const override { return &impacts_; }

 private:
  // On the ground: no vertical motion, and the friction as a rate.
  [[nodiscard]] static FixedLaws sliding_laws(FixedLaws laws) {
    laws.gravity_px_per_s2 = 0.0;
    laws.drag_rate_per_s += laws.friction_rate_per_s;
    return laws;
  }
  // x keeps its direction and y turns downwards at most, so a flight that ends inside can have met the top
  // alone.
  [[nodiscard]] static bool is_free(const State& from, const State& to, double frame_s,
                                    const Bounds& bounds) {
    if (to.x_px < 0.0 || to.x_px > bounds.right_px || to.y_px < 0.0 || to.y_px > bounds.bottom_px)
      return false;
    return kIsSwept || from.vy_px_per_s >= 0.0 || to.vy_px_per_s < 0.0 ||
           from.y_px + from.vy_px_per_s * frame_s >= 0.0;
  }
  [[nodiscard]] [[gnu::noinline]] State with_impacts(State from, double t_s, double frame_s) {
    fling_.start(from, within, slides_, frame_s);
    const State to = fling_.at(frame_s);
    slides_ = fling_.slides();
    for (const ExactImpact& impact : fling_.impacts()) impacts_.push_back({t_s + impact.t_s, impact.wall});
    return to;
  }

  // Nothing is iterated: the flight ends where its straight way meets the first wall, bounces, and the rest
  // of the frame is flown. A sprite that meets more walls than these waits there for the next frame.
  [[nodiscard]] [[gnu::noinline]] State with_swept_impacts(State m, double t_s, double frame_s) {
    constexpr int kMeetingsMax = 8;
    const ListingStep walls(laws_, AllParts{}, within);
    double left_s = frame_s;
    for (int meeting = 0; left_s > 0.0 && meeting < kMeetingsMax; ++meeting) {
      const State end = flown(m, left_s);
      const double in_x = part_until_wall(m.x_px, end.x_px, within.right_px);
      const double in_y = part_until_wall(m.y_px, end.y_px, within.bottom_px);
      const double part = std::min(in_x, in_y);
      m = part < 1.0 ? flown(m, part * left_s) : end;
      left_s -= part * left_s;
      if (in_x == part) m.x_px = end.x_px;  // Past its wall, if there is one.
      if (in_y == part) m.y_px = end.y_px;
      const std::uint8_t met = walls.meet_walls_in_x(m) | walls.meet_walls_in_y(m);
      slides_ = slides_ || (touches(met, Wall::ground) && m.vy_px_per_s == 0.0);
      for (const Wall wall : kWalls)
        if (touches(met, wall)) impacts_.push_back({t_s + frame_s - left_s, wall});
    }
    return m;
  }
  // Of the way from one position to another; 1: it ends inside. From outside it meets the wall at once.
  [[nodiscard]] static double part_until_wall(double from_px, double to_px, double far_px) {
    const double wall_px = std::clamp(to_px, 0.0, far_px);
    const double part = wall_px == to_px ? 1.0 : (wall_px - from_px) / (to_px - from_px);
    return part >= 0.0 && part <= 1.0 ? part : 0.0;
  }
  [[nodiscard]] State flown(const State& from, double t_s) const {
    ExactFlight flight{{slides_ ? sliding_ : laws_}};
    State to = from;
    flight.prepare(t_s);
    flight.fly(to);
    return to;
  }

  FixedLaws laws_{reference_model(core)};
  FixedLaws sliding_ = sliding_laws(laws_);
  ExactFling fling_{laws_};
  bool slides_ = false;
  double t_s_ = 0.0;
  std::vector<ExactImpact> impacts_;
};

// From impact to impact; the frames only say when to look.
class EventDriven final : public Method {
 public:
  explicit EventDriven(const Core& core) : fling_(FixedLaws(reference_model(core))) {}

  void start(const State& motion, const Bounds& bounds, bool goes_on) override {
    fling_.start(motion, bounds, goes_on && fling_.slides());
    now_ = motion;
    time_ = {};
  }
  [[nodiscard]] bool play(std::span<const double> frames_s) override {
    for (const double frame_s : frames_s) {
      time_.play(frame_s);
      now_ = fling_.at(time_.time_s());
    }
    return true;
  }
  [[nodiscard]] State motion() const override { return now_; }
  [[nodiscard]] const std::vector<ExactImpact>* impacts() const override { return &fling_.impacts(); }

 private:
  ExactFling fling_;
  State now_;
  Timeline time_;
};

template <class Kind>
std::function<std::unique_ptr<Method>()> maker(const Core& core) {
  return [&core] { return std::make_unique<Kind>(core); };
}

}  // namespace

std::vector<MethodKind> frame_methods(const Core& core) {
  return {{"paper", "the paper's step", "", Divergent{}, true, maker<PaperStep<1>>(core)},
          {"paper-4-substeps", "the paper's step, 4 to a frame", "", Divergent{}, true,
           maker<PaperStep<4>>(core)},
          {"normalised-drag", "the paper's step, drag by time", "", Convergent{1}, true,
           maker<FrameMethod<NormalisedFlight>>(core)},
          {"euler", "explicit Euler", "", Convergent{1}, true, maker<FrameMethod<EulerFlight>>(core)},
          {"verlet", "velocity Verlet", "", Convergent{2}, true, maker<FrameMethod<VerletFlight>>(core)},
          {"rk4", "Runge-Kutta 4", "", Convergent{4}, true, maker<FrameMethod<Rk4Flight>>(core)},
          {"exact-flight", "exact flight step", "", Exact{}, true, maker<FrameMethod<ExactFlight>>(core)},
          {"swept-clamp", "exact flight, swept clamp", "", Exact{}, true, maker<ImpactsInFrame<true>>(core)},
          {"exact-impacts", "exact flight and impacts", "", Exact{true}, true,
           maker<ImpactsInFrame<false>>(core)},
          {"event-driven", "event-driven", "", Exact{true, true}, true, maker<EventDriven>(core)}};
}

}  // namespace hyrax

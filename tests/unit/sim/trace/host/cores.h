// Cores as a header might have them, compiled with numbers that record.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

#include <sys/resource.h>

#include "sim/physics/strict_arithmetic.h"
#include "sim/trace/host/number_functions.h"

namespace hyrax::traced_cores {

// Not known to the compiler, which would warn of a recursion without end.
inline volatile unsigned kForEver = 1;

// What the system sends when the one second that a process may take is over.
inline void reach_time_limit() {
  rlimit time{};
  getrlimit(RLIMIT_CPU, &time);
  if (time.rlim_cur == 1) std::raise(SIGXCPU);
}

#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#define double ::hyrax::trace::Real
#define float ::hyrax::trace::Single
#define int ::hyrax::trace::Whole
#define bool ::hyrax::trace::Truth

#include "sim/physics/physics.h"

// All but update; T is what its members are.
template <class T = double>
struct Body {
  Body(double x, double y, double vx, double vy)
      : m_x(static_cast<T>(x)), m_y(static_cast<T>(y)), m_vx(static_cast<T>(vx)), m_vy(static_cast<T>(vy)) {}
  double x() const { return m_x; }
  double y() const { return m_y; }
  double vx() const { return m_vx; }
  double vy() const { return m_vy; }
  void setPos(double x, double y) { m_x = static_cast<T>(x), m_y = static_cast<T>(y); }
  void setVelocity(double vx, double vy) { m_vx = static_cast<T>(vx), m_vy = static_cast<T>(vy); }
  void resetVelocity() { m_vx = m_vy = static_cast<T>(0.0); }

  T m_x, m_y, m_vx, m_vy;
};

struct Plain : Body<> {
  using Body::Body;
  void update(double dt, int, int, int, int) { m_x += m_vx * dt; }
};

// Plain, and does this with dt before it.
template <void (*kDo)(double)>
struct Does : Plain {
  using Plain::Plain;
  void update(double dt, int width, int height, int object_width, int object_height) {
    kDo(dt);
    Plain::update(dt, width, height, object_width, object_height);
  }
};
inline void print_nothing(double) { std::fputs("", stdout); }
inline void spend_all_time(double) { reach_time_limit(); }
inline void throw_below_0(double dt) {
  if (dt < 0.0) throw std::invalid_argument("dt");
}
inline void end_program(double) { std::abort(); }
using Prints = Does<print_nothing>;
using Loops = Does<spend_all_time>;
using Throws = Does<throw_below_0>;
using Exits = Does<end_program>;

struct AddsZero : Body<> {  // Another bit where x is -0.
  using Body::Body;
  void update(double dt, int, int, int, int) { m_x = m_x + m_vx * dt + 0.0; }
};

struct MindsNaN : Body<> {
  using Body::Body;
  void update(double dt, int, int, int, int) {
    m_x += m_vx * dt;
    if (!std::isfinite(m_x)) m_x = 0.0;
  }
};

struct Mixed : Body<> {
  using Body::Body;
  void update(double dt, int width, int, int object, int) {
    m_x = std::max(0.0, m_x + dt * m_vx);
    m_y = std::clamp(m_y, 0.0, 100.0);
    m_vx = std::min(m_vx, static_cast<double>(std::max(width - object, 0)));
    m_vy = std::pow(m_vy, 2) + std::abs(m_vx);
  }
};

struct Floats : Body<float> {
  using Body::Body;
  static constexpr float kGravity = 1200.0f;
  void update(double dt, int width, int, int, int) {
    const float step = static_cast<float>(dt);
    m_vy += kGravity * step;
    m_y += m_vy * step;
    if (m_x > static_cast<float>(width) / 2.0) m_vx = -m_vx;
  }
};

struct Folds : Body<> {
  using Body::Body;
  static constexpr int kCount = 3;
  static constexpr double kSum = 2.0 / 4 + kCount % 2;
  static constexpr double kLargest = std::numeric_limits<double>::max();
  static constexpr std::array<double, kCount> kTable = {1.0, 2.0, kSum};
  static_assert(kSum == 1.5 && kLargest > 1e308);
  void update(double dt, int, int, int, int) {
    for (int i = 0; i < kCount; ++i)
      if (i > 0) m_x += kTable[i] * dt;
  }
};

struct Counts : Body<> {
  using Body::Body;
  int bounces = 0;
  bool was_down = false;
  double since_s = 0.0;
  void update(double dt, int, int height, int, int object) {
    m_y += m_vy * dt;
    since_s += dt;
    const bool is_down = m_y > static_cast<double>(height - object);
    if (is_down && !was_down && bounces < 3) {
      ++bounces;
      since_s = 0.0;
    }
    was_down = is_down;
  }
};

struct Integers : Body<> {
  using Body::Body;
  void update(double, int width, int, int object, int) {
    const int cell = static_cast<int>(m_x) / 16 % object;
    m_x = cell * 16 + width / 2 + width / 2.0;
  }
};

struct WhileTimeIsLeft : Body<> {
  using Body::Body;
  void update(double dt, int, int, int, int) {
    for (; dt > 0.0; dt -= 0.001) m_x += m_vx * 0.001;
  }
};

struct Remembers : Body<> {
  using Body::Body;
  void update(double dt, int, int, int, int) {
    static double last_dt = 0.0;
    m_x += m_vx * (dt + last_dt);
    last_dt = dt;
  }
};

struct Chance : Body<> {
  using Body::Body;
  void update(double, int, int, int, int) { m_x += std::rand(); }
};

struct OtherMember : Plain {
  using Plain::Plain;
  std::int64_t steps = 0;
};

struct Large : Plain {
  using Plain::Plain;
  std::array<double, 29> further{};
};

struct Divides : Body<> {
  using Body::Body;
  void update(double, int, int, int, int) {
    const int none = 0;
    m_x = 1 / none;
  }
};

struct Grows : Plain {
  using Plain::Plain;
  std::vector<double> trail;
};

struct NotAMember : Plain {
  using Plain::Plain;
  double x() const { return m_x + 1.0; }
};

struct Indexes : Body<> {
  using Body::Body;
  void update(double, int width, int, int, int) {
    const std::array<double, 2> table = {1.0, 2.0};
    m_x = table[static_cast<std::size_t>(width)];
  }
};

struct Recurses : Plain {
  using Plain::Plain;
  void update(double dt, int a, int b, int c, int d) {
    if (kForEver != 0) update(dt, a, b, c, d);
    m_x += dt;
  }
};

struct Calculates : Body<> {
  using Body::Body;
  void update(double dt, int, int, int, int) {
    while (true) m_x += dt;
  }
};

struct Allocates : Plain {
  using Plain::Plain;
  static inline char* volatile kept = nullptr;
  void update(double, int, int, int, int) {
    while (true) kept = new char[1 << 26];
  }
};

#undef double
#undef float
#undef int
#undef bool
#ifdef __clang__
#pragma clang diagnostic pop
#endif

}  // namespace hyrax::traced_cores

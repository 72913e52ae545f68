// Numbers of 256 bits, for the values that the reference is compared with.
#pragma once

#include <mpfr.h>

namespace hyrax {

/// Every operation is rounded once, to 256 bits.
class Wide {
 public:
  Wide(double value = 0.0) {  // NOLINT: a double is a Wide.
    mpfr_init2(value_, 256);
    mpfr_set_d(value_, value, MPFR_RNDN);
  }
  Wide(const Wide& other) : Wide() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Wide& operator=(const Wide& other) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  ~Wide() { mpfr_clear(value_); }

  [[nodiscard]] double rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }

  friend Wide operator+(const Wide& a, const Wide& b) { return made(mpfr_add, a, b); }
  friend Wide operator-(const Wide& a, const Wide& b) { return made(mpfr_sub, a, b); }
  friend Wide operator*(const Wide& a, const Wide& b) { return made(mpfr_mul, a, b); }
  friend Wide operator/(const Wide& a, const Wide& b) { return made(mpfr_div, a, b); }
  friend bool operator<(const Wide& a, const Wide& b) { return mpfr_less_p(a.value_, b.value_) != 0; }

  friend Wide exp(const Wide& a) { return made(mpfr_exp, a); }
  friend Wide log(const Wide& a) { return made(mpfr_log, a); }

 private:
  template <class Operation>
  static Wide made(Operation operation, const Wide& a, const Wide& b) {
    Wide result;
    operation(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }
  template <class Operation>
  static Wide made(Operation operation, const Wide& a) {
    Wide result;
    operation(result.value_, a.value_, MPFR_RNDN);
    return result;
  }

  mpfr_t value_;
};

/// phi1 and phi2 in the textbook form. It cancels 2 log2(1 / |z|) bits of the 256, so that 100 are
/// left at |z| = 1e-23; at z = 0 they are the limits.
struct WideTextbookPhi {
  explicit WideTextbookPhi(const Wide& z) {
    if (z.rounded() == 0.0) return;
    one = (exp(z) - 1.0) / z;
    two = (one - 1.0) / z;
  }
  Wide one = 1.0;
  Wide two = 0.5;
};

/// Motion along one axis under v' = g - k v.
struct WideMotion {
  Wide displacement;
  Wide speed;

  /// @param drag k t of the time to fly.
  void fly(const Wide& gravity, const Wide& drag, const Wide& t) {
    const Wide z = Wide(0.0) - drag;
    const WideTextbookPhi phi(z);
    displacement = displacement + t * (speed * phi.one + gravity * t * phi.two);
    speed = speed * exp(z) + gravity * t * phi.one;
  }
};

}  // namespace hyrax

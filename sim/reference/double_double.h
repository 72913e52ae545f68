// Unevaluated sums of two doubles: some 104 bits, with + - * / of doubles alone.
//
// Sources: T. J. Dekker, "A floating-point technique for extending the available precision",
// Numer. Math. 18:224-242, 1971; M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error
// bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017, whose
// algorithm numbers are given at the functions. Relies on uncontracted arithmetic.
#pragma once

namespace hyrax {

/// hi + lo with |lo| <= ulp(hi) / 2. Good for magnitudes up to 1e290.
struct DoubleDouble {
  double hi = 0.0;
  double lo = 0.0;
};

/// a + b exactly. REQUIRES: |a| >= |b|, or a is 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

/// a in two halves of 26 bits.
constexpr DoubleDouble split(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1.
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a * b exactly, without a fused multiply-add: the same bits on every machine.
constexpr DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble p = split(a);
  const DoubleDouble q = split(b);
  return {product, ((p.hi * q.hi - product) + p.hi * q.lo + p.lo * q.hi) + p.lo * q.lo};
}

/// Algorithm 4; relative error at most 2^-105.
constexpr DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble sum = two_sum(a.hi, b);
  return fast_two_sum(sum.hi, a.lo + sum.lo);
}

/// Algorithm 6; relative error below 2^-104, with cancellation as well.
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.hi, b.hi);
  const DoubleDouble low = two_sum(a.lo, b.lo);
  const DoubleDouble sum = fast_two_sum(high.hi, high.lo + low.hi);
  return fast_two_sum(sum.hi, low.lo + sum.lo);
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

/// Algorithm 8; relative error below 2^-103.
constexpr DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble product = two_product(a.hi, b);
  return fast_two_sum(product.hi, product.lo + a.lo * b);
}

/// Algorithm 10; relative error below 2^-102.
constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.hi, b.hi);
  return fast_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Algorithm 15; relative error below 2^-103.
constexpr DoubleDouble operator/(DoubleDouble a, double b) {
  const double quotient = a.hi / b;
  const DoubleDouble back = two_product(quotient, b);
  return fast_two_sum(quotient, ((a.hi - back.hi) + (a.lo - back.lo)) / b);
}

/// Algorithm 17, with a remainder to 100 bits; relative error below 2^-101.
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.hi / b.hi;
  const DoubleDouble rest = a + -(b * quotient);
  return fast_two_sum(quotient, (rest.hi + rest.lo) / b.hi);
}

}  // namespace hyrax

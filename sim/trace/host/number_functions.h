// The functions of <cmath> and <algorithm> for numbers that record (number.h); found by name and in std.
#pragma once

#include "sim/trace/host/number.h"

namespace hyrax::trace {

/// What a function of <cmath> calculates in: `float` only where all its arguments are.
template <Operand... T>
inline constexpr NumberKind kCallKind =
    kCommonKind<T...> == NumberKind::single ? NumberKind::single : NumberKind::real;

/// Functions whose result IEEE-754 fixes are done on constants; others wait for the machine's own library,
/// except while compiling.
template <bool kIsFixed, class Function, Operand... T>
constexpr auto call(const char* name, Function function, const T&... operands) {
  using Result = Number<kCallKind<T...>>;
  if ((Result(operands).is_constant() && ...) && (kIsFixed || std::is_constant_evaluated()))
    return Result(function(Result(operands).native()...));
  return Result::of(record_call(name, Result::kNumberKind, Result(operands).index()...));
}

// A function of <cmath> and its name in one word.
#define HYRAX_TRACE_ONE(name, is_fixed)                                                  \
  template <Recording A>                                                                 \
  constexpr auto name(const A& a) {                                                      \
    return call<is_fixed>(                                                               \
        #name, [](auto x) { return static_cast<decltype(x)>(__builtin_##name(x)); }, a); \
  }
#define HYRAX_TRACE_TWO(name, is_fixed)                                                                \
  template <class A, class B>                                                                          \
  requires Operands<A, B>                                                                              \
  constexpr auto name(const A& a, const B& b) {                                                        \
    return call<is_fixed>(                                                                             \
        #name, [](auto x, auto y) { return static_cast<decltype(x)>(__builtin_##name(x, y)); }, a, b); \
  }

HYRAX_TRACE_FUNCTIONS(HYRAX_TRACE_ONE, HYRAX_TRACE_TWO)
#undef HYRAX_TRACE_ONE
#undef HYRAX_TRACE_TWO

template <class A, class B, class C>
requires Operands<A, B, C>
constexpr auto fma(const A& a, const B& b, const C& c) {
  return call<true>(
      "fma", [](auto x, auto y, auto z) { return static_cast<decltype(x)>(std::fma(x, y, z)); }, a, b, c);
}

template <Recording N>
constexpr auto abs(const N& a) {
  if constexpr (N::kNumberKind == NumberKind::whole)
    return a < 0 ? -a : a;
  else
    return fabs(a);
}

constexpr bool isnan(const Recording auto& a) { return !(a == a); }
constexpr bool isinf(const Recording auto& a) { return fabs(a) == std::numeric_limits<double>::infinity(); }
constexpr bool isfinite(const Recording auto& a) { return fabs(a) < std::numeric_limits<double>::infinity(); }
/// Whether the sign is negative: that of 1 with the sign of a.
constexpr bool signbit(const Recording auto& a) { return copysign(Real(1.0), a) < 0.0; }

/// Operands of min, max and clamp that their own templates do not take: of different types.
template <class B, class A, class... T>
concept MixedWith = Operands<A, T..., B> && !(std::same_as<A, B> && (std::same_as<A, T> && ...));

template <Operand... T>
using CommonNumber = Number<kCommonKind<T...>>;

}  // namespace hyrax::trace

namespace std {

#define HYRAX_TRACE_USING(name, is_fixed) using hyrax::trace::name;
HYRAX_TRACE_FUNCTIONS(HYRAX_TRACE_USING, HYRAX_TRACE_USING)
#undef HYRAX_TRACE_USING
#undef HYRAX_TRACE_FUNCTIONS
using hyrax::trace::abs;
using hyrax::trace::fma;
using hyrax::trace::isfinite;
using hyrax::trace::isinf;
using hyrax::trace::isnan;
using hyrax::trace::signbit;

template <class A, hyrax::trace::MixedWith<A> B>
constexpr hyrax::trace::CommonNumber<A, B> max(const A& a, const B& b) {
  if (a < b) return b;
  return a;
}
template <class A, hyrax::trace::MixedWith<A> B>
constexpr hyrax::trace::CommonNumber<A, B> min(const A& a, const B& b) {
  if (b < a) return b;
  return a;
}
template <class T, class Low, hyrax::trace::MixedWith<T, Low> High>
constexpr hyrax::trace::CommonNumber<T, Low, High> clamp(const T& value, const Low& low, const High& high) {
  if (value < low) return low;
  if (high < value) return high;
  return value;
}

}  // namespace std

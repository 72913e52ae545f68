// Numbers that record what is done to them: a core's header is compiled with them in place of `double`,
// `float`, `int` and `bool` (traced_core.h).
//
// An operation on constants is done at once, also while compiling; every other becomes an expression of the
// recorder. A comparison asks the recorder which way to go.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "sim/trace/operation.h"

namespace hyrax::trace {

/// An expression of the recorder (recorder.h); kConstant: a number that is known.
using Index = StepIndex;
inline constexpr Index kConstant = kNoIndex;

[[nodiscard]] Index record_constant(NumberKind kind, double value);
[[nodiscard]] Index record(Operator op, NumberKind kind, Index a, Index b = kNoIndex);
[[nodiscard]] Index record_call(const char* name, NumberKind kind, Index a, Index b = kNoIndex,
                                Index c = kNoIndex);
[[nodiscard]] bool decide(Relation relation, Index left, Index right);

/// Ends the recording: the step is not complete.
[[noreturn]] void stop(const char* why_incomplete);
inline constexpr char kBecomesInteger[] = "a number becomes an integer";

/// What every number begins with is the same, so that the members of a body are found in its memory. Public:
/// a template's argument may be one.
template <NumberKind kKind>
struct Number;
using Real = Number<NumberKind::real>;
using Single = Number<NumberKind::single>;
using Whole = Number<NumberKind::whole>;

}  // namespace hyrax::trace

template <>
struct std::is_floating_point<hyrax::trace::Real> : std::true_type {};
template <>
struct std::is_floating_point<hyrax::trace::Single> : std::true_type {};
template <>
struct std::is_integral<hyrax::trace::Whole> : std::true_type {};

namespace hyrax::trace {

inline constexpr std::uint32_t kNumberTag = 0x7ace5700;  ///< And the kind in its last two bits.
inline constexpr std::uint32_t kTruthTag = kNumberTag + 3;

template <class T>
inline constexpr bool kIsNumber = false;
template <NumberKind kKind>
inline constexpr bool kIsNumber<Number<kKind>> = true;

template <class T>
concept Recording = kIsNumber<T>;
/// An enum that the language calculates with.
template <class T>
concept UnscopedEnum = std::is_enum_v<T> && std::is_convertible_v<T, std::underlying_type_t<T>>;
template <class T>
concept ScopedEnum = std::is_enum_v<T> && !UnscopedEnum<T>;
template <class T>
concept Native = (std::is_arithmetic_v<T> || UnscopedEnum<T>)&&!Recording<T>;
template <class T>
concept Operand = Native<T> || Recording<T>;
/// Operands of one of our operators: the built-in ones keep their own.
template <class... T>
concept Operands = (Operand<T> && ...) && (Recording<T> || ...);
template <class T>
concept NativeInteger = Native<T> && std::is_integral_v<T> && !std::same_as<T, bool>;
template <class T>
inline constexpr bool kCounts = std::same_as<T, std::size_t> || std::same_as<T, std::ptrdiff_t>;

template <NumberKind kKind>
using NativeOf = std::conditional_t<kKind == NumberKind::real, double,
                                    std::conditional_t<kKind == NumberKind::single, float, int>>;

template <Operand T>
constexpr NumberKind kind_of() {
  if constexpr (Recording<T>)
    return T::kNumberKind;
  else if constexpr (std::is_same_v<T, float>)
    return NumberKind::single;
  else
    return std::is_floating_point_v<T> ? NumberKind::real : NumberKind::whole;
}

/// What the language converts the operands of an operation to.
template <Operand... T>
inline constexpr NumberKind kCommonKind = ((kind_of<T>() == NumberKind::real) || ...)     ? NumberKind::real
                                          : ((kind_of<T>() == NumberKind::single) || ...) ? NumberKind::single
                                                                                          : NumberKind::whole;

/// A built-in integer with which the language would not calculate in `int`.
template <class T>
inline constexpr bool kIsWiderThanInt =
    Native<T>&& std::is_integral_v<T> && !std::is_same_v<T, int> && sizeof(T) >= sizeof(int);
template <UnscopedEnum T>
inline constexpr bool kIsWiderThanInt<T> = kIsWiderThanInt<decltype(+T())>;

template <NumberKind kKind>
constexpr NativeOf<kKind> native_of(double value) {
  if constexpr (kKind == NumberKind::whole)
    if (!(value > -2147483649.0 && value < 2147483648.0)) stop(kBecomesInteger);
  return static_cast<NativeOf<kKind>>(value);
}

template <NumberKind kKind>
struct Number {
  double value = 0.0;  // Of a constant.
  Index expression = kConstant;
  std::uint32_t tag = kNumberTag + static_cast<std::uint32_t>(kKind);

  static constexpr NumberKind kNumberKind = kKind;

  constexpr Number() = default;
  template <Native T>
  constexpr Number(T constant) : value(static_cast<double>(static_cast<NativeOf<kKind>>(constant))) {}
  template <ScopedEnum T>
  constexpr explicit Number(T constant) : Number(static_cast<std::underlying_type_t<T>>(constant)) {}
  template <NumberKind kOther>
  constexpr Number(const Number<kOther>& other) {
    constexpr Operator kTo = kKind == NumberKind::real     ? Operator::to_real
                             : kKind == NumberKind::single ? Operator::to_single
                                                           : Operator::to_whole;
    if (other.is_constant())
      value = static_cast<double>(native_of<kKind>(other.value));
    else
      expression = record(kTo, kKind, other.expression);
  }
  static constexpr Number of(Index index) {
    Number number;
    number.expression = index;
    return number;
  }

  [[nodiscard]] constexpr bool is_constant() const { return expression == kConstant; }
  [[nodiscard]] constexpr NativeOf<kKind> native() const { return native_of<kKind>(value); }
  [[nodiscard]] constexpr Index index() const {
    return is_constant() ? record_constant(kKind, value) : expression;
  }

  // What indexes and counts in the header's own way: only a constant can be followed there.
  template <NativeInteger T>
  constexpr explicit(kKind != NumberKind::whole || !kCounts<T>) operator T() const {
    if (!is_constant()) stop(kBecomesInteger);
    return static_cast<T>(native());
  }
  template <class T>
  requires std::is_enum_v<T>
  constexpr explicit operator T() const {
    return static_cast<T>(static_cast<std::underlying_type_t<T>>(*this));
  }
  constexpr explicit operator bool() const { return *this != 0; }

  constexpr Number& operator+=(const Operand auto& other) { return *this = *this + other; }
  constexpr Number& operator-=(const Operand auto& other) { return *this = *this - other; }
  constexpr Number& operator*=(const Operand auto& other) { return *this = *this * other; }
  constexpr Number& operator/=(const Operand auto& other) { return *this = *this / other; }
  constexpr Number& operator%=(const Operand auto& other) { return *this = *this % other; }
  constexpr Number& operator++() { return *this += 1; }
  constexpr Number& operator--() { return *this -= 1; }
  constexpr Number operator++(int) {
    const Number before = *this;
    *this += 1;
    return before;
  }
  constexpr Number operator--(int) {
    const Number before = *this;
    *this -= 1;
    return before;
  }
};

template <Operator kOp, NumberKind kKind>
constexpr NativeOf<kKind> fold(NativeOf<kKind> a, NativeOf<kKind> b) {
  using Wide = std::conditional_t<kKind == NumberKind::whole, std::int64_t, NativeOf<kKind>>;
  if constexpr (kKind == NumberKind::whole)
    if ((kOp == Operator::divide || kOp == Operator::remainder) && b == 0)
      stop("over its limits: divides an integer by 0");
  Wide result = 0;
  if constexpr (kOp == Operator::add) result = Wide{a} + Wide{b};
  if constexpr (kOp == Operator::multiply) result = Wide{a} * Wide{b};
  if constexpr (kOp == Operator::divide) result = Wide{a} / Wide{b};
  if constexpr (kOp == Operator::remainder) result = Wide{a} % Wide{b};
  return static_cast<NativeOf<kKind>>(result);
}

template <Operator kOp, Operand A, Operand B>
constexpr auto combine(const A& a, const B& b) {
  constexpr NumberKind kKind = kCommonKind<A, B>;
  const Number<kKind> left(a);
  const Number<kKind> right(b);
  if (left.is_constant() && right.is_constant())
    return Number<kKind>(fold<kOp, kKind>(left.native(), right.native()));
  if constexpr (kKind == NumberKind::whole)
    if (kIsWiderThanInt<A> || kIsWiderThanInt<B>) stop(kBecomesInteger);
  return Number<kKind>::of(record(kOp, kKind, left.index(), right.index()));
}

constexpr auto operator+(const Recording auto& a) { return a; }
template <Recording N>
constexpr N operator-(const N& a) {
  return a.is_constant() ? N(-a.native()) : N::of(record(Operator::negate, N::kNumberKind, a.expression));
}
template <class A, class B>
requires Operands<A, B>
constexpr auto operator+(const A& a, const B& b) { return combine<Operator::add>(a, b); }
template <class A, class B>
requires Operands<A, B>
constexpr auto operator-(const A& a, const B& b) {
  return combine<Operator::add>(a, -Number<kCommonKind<A, B>>(b));
}
template <class A, class B>
requires Operands<A, B>
constexpr auto operator*(const A& a, const B& b) { return combine<Operator::multiply>(a, b); }
template <class A, class B>
requires Operands<A, B>
constexpr auto operator/(const A& a, const B& b) { return combine<Operator::divide>(a, b); }
template <class A, class B>
requires(Operands<A, B>&& kCommonKind<A, B> == NumberKind::whole) constexpr auto operator%(const A& a,
                                                                                           const B& b) {
  return combine<Operator::remainder>(a, b);
}

template <Relation kRelation, Operand A, Operand B>
constexpr bool compare(const A& a, const B& b) {
  constexpr NumberKind kKind = kCommonKind<A, B>;
  const Number<kKind> left(a);
  const Number<kKind> right(b);
  if (left.is_constant() && right.is_constant()) {
    if constexpr (kRelation == Relation::less) return left.value < right.value;
    if constexpr (kRelation == Relation::less_or_equal) return left.value <= right.value;
    return left.value == right.value;
  }
  if constexpr (kKind == NumberKind::whole)
    if (kIsWiderThanInt<A> || kIsWiderThanInt<B>) stop(kBecomesInteger);
  return decide(kRelation, left.index(), right.index());
}

template <class A, class B>
requires Operands<A, B>
constexpr bool operator<(const A& a, const B& b) { return compare<Relation::less>(a, b); }
template <class A, class B>
requires Operands<A, B>
constexpr bool operator>(const A& a, const B& b) { return compare<Relation::less>(b, a); }
template <class A, class B>
requires Operands<A, B>
constexpr bool operator<=(const A& a, const B& b) { return compare<Relation::less_or_equal>(a, b); }
template <class A, class B>
requires Operands<A, B>
constexpr bool operator>=(const A& a, const B& b) { return compare<Relation::less_or_equal>(b, a); }
template <class A, class B>
requires Operands<A, B>
constexpr bool operator==(const A& a, const B& b) { return compare<Relation::equal>(a, b); }
template <class A, class B>
requires Operands<A, B>
constexpr bool operator!=(const A& a, const B& b) { return !compare<Relation::equal>(a, b); }
constexpr bool operator!(const Recording auto& a) { return a == 0; }

/// A `bool`: as a member 0 or 1, asked for where it is used.
struct Truth {
  double value = 0.0;
  Index expression = kConstant;
  std::uint32_t tag = kTruthTag;

  constexpr Truth() = default;
  constexpr Truth(bool constant) : value(constant ? 1.0 : 0.0) {}
  constexpr Truth(const Recording auto& number) : Truth(number != 0) {}

  constexpr operator bool() const {
    return expression == kConstant ? value != 0.0 : Whole::of(expression) != 0;
  }
  constexpr Truth& operator&=(bool other) { return *this = *this && other; }
  constexpr Truth& operator|=(bool other) { return *this = *this || other; }
  constexpr Truth& operator^=(bool other) { return *this = static_cast<bool>(*this) != other; }
};

static_assert(sizeof(Real) == 16 && sizeof(Single) == 16 && sizeof(Whole) == 16 && sizeof(Truth) == 16);

}  // namespace hyrax::trace

template <hyrax::NumberKind kKind>
struct std::numeric_limits<hyrax::trace::Number<kKind>> : std::numeric_limits<hyrax::trace::NativeOf<kKind>> {
  using Number = hyrax::trace::Number<kKind>;
  using Native = std::numeric_limits<hyrax::trace::NativeOf<kKind>>;
  static constexpr Number min() { return Native::min(); }
  static constexpr Number max() { return Native::max(); }
  static constexpr Number lowest() { return Native::lowest(); }
  static constexpr Number epsilon() { return Native::epsilon(); }
  static constexpr Number round_error() { return Native::round_error(); }
  static constexpr Number infinity() { return Native::infinity(); }
  static constexpr Number quiet_NaN() { return Native::quiet_NaN(); }
  static constexpr Number signaling_NaN() { return Native::signaling_NaN(); }
  static constexpr Number denorm_min() { return Native::denorm_min(); }
};

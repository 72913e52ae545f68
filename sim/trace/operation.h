// The operations of a traced step. Apart from traced_step.h, since the host compiles it with every core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hyrax {

/// A place among the expressions, comparisons, paths or nodes of a step.
using StepIndex = std::uint32_t;
inline constexpr StepIndex kNoIndex = ~StepIndex{0};

/// The arithmetic of an expression: that of the header's `double`, `float` or `int`.
enum class NumberKind : std::uint8_t { real, single, whole };
inline constexpr std::array<std::string_view, 3> kNumberKindNames = {"real", "single", "whole"};
[[nodiscard]] constexpr std::string_view name_of(NumberKind kind) {
  return kNumberKindNames[static_cast<std::size_t>(kind)];
}

enum class Operator : std::uint8_t {
  argument,  ///< A member before the step, or an argument of the function; Expression::name.
  constant,  ///< Expression::value, never negative: -0.5 is the negation of 0.5.
  negate,
  add,
  multiply,
  divide,
  remainder,
  to_real,    ///< Conversion to double.
  to_single,  ///< Conversion to float.
  to_whole,   ///< Conversion to int, towards 0.
  call        ///< A function of the standard library by its name: "sqrt", "fabs", "pow", "fma" ...
};

inline constexpr std::string_view kOperatorSigns = "+*/%";  ///< From Operator::add on.

/// Empty of what is not binary.
[[nodiscard]] constexpr std::string_view sign_of(Operator op) {
  if (op < Operator::add || op > Operator::remainder) return {};
  return kOperatorSigns.substr(static_cast<std::size_t>(op) - static_cast<std::size_t>(Operator::add), 1);
}

enum class Relation : std::uint8_t { less, less_or_equal, equal };
inline constexpr std::array<std::string_view, 3> kRelationSigns = {"<", "<=", "=="};
[[nodiscard]] constexpr std::string_view sign_of(Relation relation) {
  return kRelationSigns[static_cast<std::size_t>(relation)];
}

/// The functions of one and of two numbers that a step may call besides `fma`: one(name, is_fixed), where
/// IEEE-754 fixes the result or not.
// Each name stands for a function and for a text.
#define HYRAX_TRACE_FUNCTIONS(one, two)                                                               \
  one(fabs, true) one(sqrt, true) one(floor, true) one(ceil, true) one(trunc, true) one(round, true)  \
      one(rint, true) one(nearbyint, true) one(cbrt, false) one(exp, false) one(exp2, false)          \
          one(expm1, false) one(log, false) one(log2, false) one(log10, false) one(log1p, false)      \
              one(sin, false) one(cos, false) one(tan, false) one(asin, false) one(acos, false)       \
                  one(atan, false) one(sinh, false) one(cosh, false) one(tanh, false) two(pow, false) \
                      two(atan2, false) two(hypot, false) two(fmod, true) two(remainder, true)        \
                          two(copysign, true) two(fmin, true) two(fmax, true)

/// The functions of a core; of the names of their arguments and of members see traced_step.h.
enum class CoreFunction : std::uint8_t { construct, update, set_position, set_velocity, reset_velocity };

}  // namespace hyrax

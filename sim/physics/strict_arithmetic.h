// Refuses builds and machines on which a double operation is not one IEEE-754 binary64 operation,
// rounded to nearest: there the core would move other bits than its golden files.
#pragma once

#include <cfloat>
#include <limits>
#include <optional>
#include <string_view>

// Only the must-fail controls of the tests lift these guards, to show that the run-time check
// catches what they refuse.
#ifndef HYRAX_CONTROL_WITHOUT_GUARDS
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || defined(_M_FP_FAST) ||                                     \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "hyrax: -ffast-math changes the bits of the core, as each of its parts does; build without them"
#endif
static_assert(FLT_EVAL_METHOD == 0,
              "hyrax: doubles are kept with excess precision (x87); build for SSE2 or a 64-bit target");
static_assert(std::numeric_limits<double>::is_iec559, "hyrax: double is not IEEE-754 binary64");
#endif

namespace hyrax {

/// Looks for what a compiler guard cannot see: contraction into fused multiply-adds, flush-to-zero
/// or denormals-are-zero (perhaps set by a loaded library), x87 excess precision, another rounding
/// mode. Tests arithmetic alone, never the model. Costs some nanoseconds.
/// @return a sentence that names the fault and its usual cause; nothing where all is well.
[[nodiscard]] std::optional<std::string_view> arithmetic_fault();

}  // namespace hyrax

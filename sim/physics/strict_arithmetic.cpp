#include "sim/physics/strict_arithmetic.h"

#include <cfenv>

namespace hyrax {
namespace {

// (1 + e)(1 - e) - 1 = -e^2 is lost when the product is rounded, and kept when it is fused.
bool is_contracted() {
  volatile double above = 1.0 + DBL_EPSILON;
  volatile double below = 1.0 - DBL_EPSILON;
  volatile double minus_one = -1.0;
  const double residual = above * below + minus_one;
  return residual != 0.0;
}

bool flushes_subnormal_results() {
  volatile double smallest_normal = DBL_MIN;
  volatile double half = smallest_normal / 2.0;
  return half == 0.0;
}

bool reads_subnormals_as_zero() {
  volatile double subnormal = std::numeric_limits<double>::denorm_min();
  volatile double scaled = subnormal * 0x1p52;
  return scaled == 0.0;
}

// 1 + 2^-53 + 2^-64 lies just above a tie: 64-bit significands round it twice, first to the tie.
bool has_excess_precision() {
  volatile double one = 1.0;
  volatile double just_above_half_ulp = 0x1p-53 + 0x1p-64;
  volatile double sum = one + just_above_half_ulp;
  volatile double one_third = one / 3.0;
  const double unstored = one / 3.0;
  return sum != 1.0 + DBL_EPSILON || unstored != one_third;
}

bool rounds_elsewhere() {
  volatile double one = 1.0;
  volatile double quarter_ulp = DBL_EPSILON / 4.0;
  volatile double up = one + quarter_ulp;
  volatile double down = one - quarter_ulp / 2.0;
  return std::fegetround() != FE_TONEAREST || up != 1.0 || down != 1.0;
}

}  // namespace

std::optional<std::string_view> arithmetic_fault() {
  if (rounds_elsewhere())
    return "floating-point results are not rounded to nearest; a loaded library or the caller "
           "changed the rounding mode";
  if (is_contracted())
    return "multiply-adds are fused (contracted); build with -ffp-contract=off, which the CMake "
           "target hyrax::physics carries";
  if (flushes_subnormal_results() || reads_subnormals_as_zero())
    return "subnormal numbers are flushed to zero; something in this process was linked with "
           "-ffast-math or set FTZ/DAZ";
  if (has_excess_precision())
    return "intermediate results carry excess precision (x87); build for SSE2 or a 64-bit target";
  return std::nullopt;
}

}  // namespace hyrax

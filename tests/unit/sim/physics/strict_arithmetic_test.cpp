// The self-test of arithmetic: passes on a strict machine, and detects modes that a caller can change.
#include "sim/physics/strict_arithmetic.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace hyrax {
namespace {

// The self-test's result in this rounding mode.
std::string fault_when_rounding(int mode) {
  std::fesetround(mode);
  const auto fault = arithmetic_fault();
  std::fesetround(FE_TONEAREST);
  return std::string(fault.value_or(""));
}

TEST(StrictArithmetic, PassesHere) { EXPECT_EQ(arithmetic_fault().value_or(""), ""); }

TEST(StrictArithmetic, FindsAnotherRoundingUntilItIsRestored) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    EXPECT_NE(fault_when_rounding(mode).find("rounding mode"), std::string::npos) << mode;
  EXPECT_EQ(arithmetic_fault().value_or(""), "");
}

#if defined(__SSE2__)
constexpr unsigned kFlushToZero = 0x8000u;
constexpr unsigned kDenormalsAreZero = 0x0040u;

// The self-test's result with these bits of the control register set.
std::string fault_with_control_bits(unsigned bits) {
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | bits);
  const auto fault = arithmetic_fault();
  _mm_setcsr(saved);
  return std::string(fault.value_or(""));
}

TEST(StrictArithmetic, FindsSubnormalsFlushedToZeroUntilTheyAreRestored) {
  for (const unsigned bits : {kFlushToZero, kDenormalsAreZero, kFlushToZero | kDenormalsAreZero})
    EXPECT_NE(fault_with_control_bits(bits).find("flushed to zero"), std::string::npos) << bits;
  EXPECT_EQ(arithmetic_fault().value_or(""), "");
}

#endif

}  // namespace
}  // namespace hyrax
